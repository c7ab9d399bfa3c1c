#pragma once
// How many times as fast one thing is as another, on a machine with other work.

#include "validation/harness/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace clack::validation {

/// The middle one of several, with the standard error that a median of normal numbers has.
inline Estimate median_of(std::vector<double> values) {
    Estimate const mean = mean_of(values);
    std::sort(values.begin(), values.end());
    std::size_t const half = values.size() / 2;
    double const median =
        values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
    return {median, std::sqrt(std::numbers::pi / 2) * mean.error, mean.degrees_of_freedom};
}

/// The risks where times are compared: a few replicates on a machine with other work could not
/// tell anything apart by those of an experiment that counts.
constexpr Risks of_timing{.false_alarm = 0.01};

/// Measures so many state points, and those that stay undecided again: on a machine with other work
/// ratios wander.
///   measure(k, times)   measures point k with so many times its replicates
///   judge()             judges all together and returns, point by point, what is undecided
template <class Measure, class Judge>
void measure_until_decided(std::size_t const points, Measure const& measure, Judge const& judge) {
    constexpr int longest = 4;
    std::vector<bool> open(points, true);
    for (int times = 1; times <= longest; ++times) {
        for (std::size_t k = 0; k < points; ++k)
            if (open[k]) measure(k, times);
        open = judge();
    }
}

/// "Is the factor at least this?" as a comparison of logarithms.
inline Comparison at_least(double const least, Estimate const& factor) {
    return {.measured = {std::log(factor.value), factor.error / factor.value,
                         factor.degrees_of_freedom},
            .reference = std::log(least),
            .asks = Asks::whether_at_least};
}

} // namespace clack::validation
