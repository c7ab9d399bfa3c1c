#pragma once
// Times on a machine with other work: how long something took, and how many times as fast one thing
// is as another.

#include "validation/statistics/verdict.hpp"

#include <cmath>
#include <cstddef>
#include <ctime>
#include <vector>

namespace clack::validation {

/// Processor time of this thread so far.  [s]
inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
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
