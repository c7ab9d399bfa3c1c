#pragma once
// Equation of state of the fluid: state points, one measurement, and what it should give.

#include "observables/pressure.hpp"
#include "reference/equation_of_state.hpp"
#include "reference/finite_size.hpp"
#include "validation/harness/campaign.hpp"
#include "validation/harness/engine_maker.hpp"
#include "validation/harness/options.hpp"
#include "validation/harness/verdict.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace clack::validation::equation_of_state {

/// Where on the equation of state, and how long.
struct StatePoint {
    double packing_fraction;
    std::int64_t count;
    double equilibration; // collisions per ball before anything is counted
    double production;    // collisions per ball that are counted, in one replicate
    int replicates;

    double number_density() const { return packing_fraction * 6 / std::numbers::pi; }
    std::string text() const {
        return fmt::format("packing_fraction={} count={} equilibration={} production={}",
                           packing_fraction, count, equilibration, production);
    }
};

/// The fluid from dilute to just below freezing (packing fraction 0.492). Few balls where that is
/// safe: there the 1/N terms are large enough to be tested too.
inline std::vector<StatePoint> state_points(Profile const profile) {
    if (profile == Profile::quick) {
        // So long that the margin is five standard errors: too few leave a point undecided.
        return {{0.05, 500, 30, 1600, 16},  {0.10, 108, 30, 14'000, 16},
                {0.15, 500, 30, 1000, 16},  {0.20, 108, 30, 10'000, 16},
                {0.30, 500, 50, 2000, 16},  {0.40, 500, 100, 2500, 16},
                {0.45, 864, 200, 1800, 16}, {0.49, 864, 300, 2000, 16}};
    }
    std::vector<StatePoint> points;
    for (double const eta : {0.05, 0.10, 0.15, 0.20, 0.25, 0.30, 0.35, 0.40, 0.45, 0.47, 0.49}) {
        bool const few = eta == 0.10 || eta == 0.20;
        points.push_back({eta, few ? 108 : 864, 500, few ? 80'000.0 : 20'000.0, 20});
    }
    return points;
}

/// A difference that would not matter, as a part of Zc, the collisional part of Z.
/// A diameter wrong by 0.1 % changes Zc by 0.3 % where it changes it least, in the dilute gas, and
/// by 1.1 % at freezing; the margin is two thirds, and in the full profile one third, of that least
/// effect. What the finite-size law leaves out stays below it at these numbers of balls.
constexpr double margin(Profile const profile) { return profile == Profile::quick ? 2e-3 : 1e-3; }

/// Relative error of the theory's Z.
constexpr double theory_error = 2e-5;

/// What one replicate measures: the compressibility factor of N balls, in two ways, and the
/// standard error of the first from this replicate alone, by blocking.
enum Value : std::size_t { by_virial, by_rate, blocked_error };

/// How often a replicate is looked at: enough for blocks of many lengths.
constexpr int looks = 256;

inline Scene scene_of(StatePoint const& point, std::uint64_t const seed) {
    Scene scene;
    scene.system.boundary = Boundary::periodic;
    scene.system.count = point.count;
    scene.system.side = std::cbrt(static_cast<double>(point.count) / point.number_density());
    scene.arrangement = Arrangement::random;
    scene.seed = seed;
    return scene;
}

/// The compressibility factor from the virial of the collisions, as a run reports it, and from
/// their number. The spans of equilibration and of production are times that are fixed beforehand:
/// one that ended with a collision would favour moments of many.
inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(scene_of(point, seed));
    System const& system = engine->system();
    auto const count = static_cast<double>(point.count);
    double const freedom = system.degrees_of_freedom();
    double const rate = reference::collision_rate(
        reference::collisional_compressibility(point.number_density(), point.count), freedom);

    engine->advance({.time = point.equilibration / rate});
    engine->start_clock();
    double const time = point.production / rate;
    double const energy = engine->kinetic_energy();
    Tallies const& tallies = engine->tallies();
    std::vector<Sample> samples{{0, {}, energy}};
    for (int look = 1; look <= looks; ++look) {
        double const when = time * look / looks;
        engine->advance({.time = when});
        samples.push_back({when, tallies, energy});
    }
    double const kt = temperature(system, energy, engine->momentum());
    auto const virial = compressibility_factor(system, kt, samples).virial.value();
    double const collisions_per_ball = 2 * static_cast<double>(tallies.ball_collisions) / count;
    double const thermal_rate =
        collisions_per_ball / time * system.diameter * std::sqrt(system.mass / kt);
    return {virial.value, 1 - 1 / count + reference::collisional_from_rate(thermal_rate, freedom),
            virial.error.value_or(std::numeric_limits<double>::quiet_NaN())};
}

/// Standard error of the mean over all replicates, from what blocking says of each.
inline double error_by_blocking(std::vector<Measurement> const& replicates) {
    double squares = 0;
    for (Measurement const& measurement : replicates)
        squares += measurement[blocked_error] * measurement[blocked_error];
    return std::sqrt(squares) / static_cast<double>(replicates.size());
}

/// One of the values of all replicates beside the theory's.
inline Comparison compare(StatePoint const& point, std::vector<Measurement> const& replicates,
                          Value const value, double const relative_margin) {
    std::vector<double> values;
    for (Measurement const& measurement : replicates) values.push_back(measurement[value]);
    double const rho = point.number_density();
    return {.name = point.text() + (value == by_virial ? " virial" : " rate"),
            .measured = mean_of(values),
            .reference = reference::periodic_compressibility(rho, point.count),
            .reference_error = theory_error * reference::modified_klm(point.packing_fraction),
            .margin = relative_margin * reference::collisional_compressibility(rho, point.count)};
}

} // namespace clack::validation::equation_of_state
