#pragma once
// What the experiments on speed have in common: cubes of balls, and runs that are timed in turn.

#include "simulation/engine.hpp"
#include "validation/records/campaign.hpp"
#include "validation/timing.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace clack::validation {

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
    std::uint64_t done = 0; // collisions, timed or not

    /// Processor time of a slice of collisions. A third goes first, untimed: others have had the
    /// caches meanwhile.
    double go(std::uint64_t const slice) {
        done += slice / 3;
        engine->advance({.ball_collisions = done}, observer.get());
        double const begin = processor_seconds();
        done += slice;
        engine->advance({.ball_collisions = done}, observer.get());
        return processor_seconds() - begin;
    }
};

/// The middle one of a function of what each replicate measured.
template <std::invocable<Measurement> Function>
Estimate median_of(std::vector<Measurement> const& replicates, Function const& function) {
    std::vector<double> values;
    for (Measurement const& measurement : replicates) values.push_back(function(measurement));
    return median_of(values);
}

} // namespace clack::validation
