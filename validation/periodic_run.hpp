#pragma once
// A run in a periodic cube and what its collisions say about the pressure, for the experiments on
// the fluid and the crystal in equilibrium.

#include "observables/pressure.hpp"
#include "validation/periodic_fluid.hpp"

#include <functional>
#include <limits>

namespace clack::validation {

/// So many runs of the same length.
struct PeriodicRun : PeriodicFluid {
    double equilibration; // collisions per ball before anything is counted
    double production;    // collisions per ball that are counted
    int replicates = 16;

    std::string text() const {
        return fmt::format("{} equilibration={} production={} {}", PeriodicFluid::text(),
                           equilibration, production, is_crystal() ? "fcc" : "random");
    }
    /// That are counted, in so many replicates.
    double collisions(std::size_t const measured) const {
        return static_cast<double>(measured) * production * static_cast<double>(count) / 2;
    }
};

/// Looks at the balls, so many times at equal intervals of a run's production, the last at its end.
struct Looks {
    int count = 0;
    std::function<void(Snapshot const&)> look = {};
};

/// The compressibility factor of N balls from the virial of the collisions, as a run reports it,
/// and from their number; the standard error of the first from this run alone, by blocking.
struct CompressibilityTwice {
    double by_virial, by_rate, virial_error;
};

/// The spans of equilibration and of production are times that are fixed beforehand: one that ended
/// with a collision would favour moments of many.
inline CompressibilityTwice run_periodic(PeriodicRun const& run, Engine& engine,
                                         Looks const& looks = {}) {
    System const& system = engine.system();
    auto const count = static_cast<double>(run.count);
    engine.advance({.time = run.equilibration / run.collision_rate()});
    engine.start_clock();
    double const time = run.production / run.collision_rate();
    constexpr int enough_for_blocks = 256;
    int const spans = looks.count > 0 ? looks.count : enough_for_blocks;
    double const energy = engine.kinetic_energy();
    Tallies const& tallies = engine.tallies();
    std::vector<Sample> samples{{0, {}, energy}};
    for (int span = 1; span <= spans; ++span) {
        double const when = span == spans ? time : span * time / spans;
        engine.advance({.time = when});
        samples.push_back({when, tallies, energy});
        if (looks.count > 0) looks.look(engine.snapshot());
    }

    double const kt = temperature(system, energy, engine.momentum());
    auto const virial = compressibility_factor(system, kt, samples).virial.value();
    double const collisions_per_ball = 2 * static_cast<double>(tallies.ball_collisions) / count;
    double const thermal_rate =
        collisions_per_ball / time * system.diameter * std::sqrt(system.mass / kt);
    return {virial.value,
            1 - 1 / count +
                reference::collisional_from_rate(thermal_rate, system.degrees_of_freedom()),
            virial.error.value_or(std::numeric_limits<double>::quiet_NaN())};
}

} // namespace clack::validation
