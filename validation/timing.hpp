#pragma once
// What the experiments on speed have in common: cubes of balls, runs that are timed in turn, and
// how many times as fast one thing is as another on a machine with other work.

#include "simulation/engine.hpp"
#include "validation/statistics/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

namespace clack::validation {

/// Processor time of this thread so far.  [s]
inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline System cube(Boundary const boundary, std::int64_t const count,
                   double const packing_fraction) {
    System made;
    made.boundary = boundary;
    made.count = count;
    made.side = std::cbrt(static_cast<double>(count) * std::numbers::pi / (6 * packing_fraction));
    return made;
}

inline char const* name_of(Boundary const boundary) {
    return boundary == Boundary::walls ? "walls" : "periodic";
}

/// Where the balls of an engine are, for others to start from.
inline Start start_of(Engine const& engine) {
    Snapshot const snapshot = engine.snapshot();
    return {snapshot.positions, snapshot.velocities};
}

/// An engine on its way, timed a slice at a time.
struct TimedRun {
    std::unique_ptr<Engine> engine;
    std::unique_ptr<CollisionObserver> observer = {};
    std::function<void(Engine const&)> look = {}; // taken once for each collision of a ball
    std::uint64_t done = 0;                       // collisions, timed or not

    /// Processor time of a slice of collisions. A third goes first, untimed: others have had the
    /// caches meanwhile.
    double go(std::uint64_t const slice) {
        advance(slice / 3);
        double const begin = processor_seconds();
        advance(slice);
        return processor_seconds() - begin;
    }
    void advance(std::uint64_t const slice) {
        std::uint64_t const end = done + slice;
        auto const between =
            static_cast<std::uint64_t>(std::max<std::int64_t>(engine->system().count / 2, 1));
        while (done < end) {
            done = look ? std::min(done + between, end) : end;
            engine->advance({.ball_collisions = done}, observer.get());
            if (look) look(*engine);
        }
    }
};

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
