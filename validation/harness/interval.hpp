#pragma once
// A mean over replicates and how well it is known.

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

/// Mean over independent replicates, with the standard error of the mean.
/// Throws std::invalid_argument for fewer than two.
Estimate mean_of(std::vector<double> const& replicates);

/// Half the width of Student's interval that holds the true mean with this confidence.
///   confidence   in (0, 1)
double half_width(Estimate const& estimate, double confidence);

/// Probability that Student's t with so many degrees of freedom (infinity: a normal deviate)
/// exceeds t.
double upper_tail(double t, double degrees_of_freedom);

} // namespace clack::validation
