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

/// "Is the factor at least this?" as a comparison of logarithms, which agrees anywhere between
/// `least` and a factor that nothing reaches.
inline Comparison at_least(double const least, Estimate const& factor) {
    constexpr double unreachable = 1e6;
    double const reach = std::log(unreachable / least) / 2;
    return {.name = {},
            .measured = {std::log(factor.value), factor.error / factor.value,
                         factor.degrees_of_freedom},
            .reference = std::log(least) + reach,
            .reference_error = 0,
            .margin = reach};
}

} // namespace clack::validation
