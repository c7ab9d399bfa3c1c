#pragma once
// Numbers with errors: means over replicates, medians, straight lines, series that remember.

#include <concepts>
#include <limits>
#include <vector>

namespace clack::validation {

/// A measured number with its standard error, the error itself being known from so many degrees of
/// freedom (infinity: exactly).
struct Estimate {
    double value = 0;
    double error = 0;
    double degrees_of_freedom = std::numeric_limits<double>::infinity();
};

/// What one replicate of a state point measured, in the order that the experiment gives it.
using Measurement = std::vector<double>;

/// Mean over independent replicates, with the standard error of the mean.
/// Throws std::invalid_argument for fewer than two.
Estimate mean_of(std::vector<double> const& replicates);

/// The middle one of several, with the standard error that a median of normal numbers has.
Estimate median_of(std::vector<double> values);

/// A function of what each replicate measured.
template <std::invocable<Measurement> Function>
std::vector<double> values_of(std::vector<Measurement> const& replicates,
                              Function const& function) {
    std::vector<double> values;
    for (Measurement const& measurement : replicates) values.push_back(function(measurement));
    return values;
}

/// The mean of a function, or of one of the values, and the middle one.
template <std::invocable<Measurement> Function>
Estimate mean_of(std::vector<Measurement> const& replicates, Function const& function) {
    return mean_of(values_of(replicates, function));
}
template <std::invocable<Measurement> Function>
Estimate median_of(std::vector<Measurement> const& replicates, Function const& function) {
    return median_of(values_of(replicates, function));
}
Estimate mean_of(std::vector<Measurement> const& replicates, std::size_t place);

/// Half the width of Student's interval that holds the true mean with this confidence.
///   confidence   in (0, 1)
double half_width(Estimate const& estimate, double confidence);

/// Probability that Student's t with so many degrees of freedom (infinity: a normal deviate)
/// exceeds t.
double upper_tail(double t, double degrees_of_freedom);

/// How many members of a series weigh as much as one independent one: (error of the mean by
/// blocking / error if they were independent)^2, 1 for an independent series. Throws
/// std::invalid_argument for a series too short to tell, or of equal members.
double statistical_inefficiency(std::vector<double> const& series);

struct StraightLine {
    double at_0 = 0, slope = 0;
};

/// The straight line through points, by least squares.
StraightLine line_through(std::vector<double> const& x, std::vector<double> const& y);

/// The same with errors, from those of the points.
struct MeasuredLine {
    Estimate at_0, slope;
};
MeasuredLine line_through(std::vector<double> const& x, std::vector<Estimate> const& y);

/// The larger of two errors; not a number where one of them is none, so that nothing passes because
/// it could not be judged.
double worse(double a, double b);

} // namespace clack::validation
