#pragma once
// Pressure on the walls of a cube: state points, one measurement, and what it should give.

#include "observables/density_profile.hpp"
#include "observables/pressure.hpp"
#include "observables/radial_distribution.hpp"
#include "reference/equation_of_state.hpp"
#include "reference/finite_size.hpp"
#include "reference/two_balls.hpp"
#include "reference/walled_fluid.hpp"
#include "validation/harness/engine_maker.hpp"
#include "validation/harness/findings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace clack::validation::wall_pressure {

/// Balls in a cube with walls, wall to wall `side` diameters; 2 of them, whose pressure is known
/// exactly, or so many that the middle is bulk.
struct StatePoint {
    std::int64_t count;
    double side;
    double production; // collisions per ball that are counted, in one replicate
    int looks;         // at the places of the balls
    int replicates;

    std::string text() const {
        return fmt::format("count={} side={} production={} looks={}", count, side, production,
                           looks);
    }
    double overall_density() const { return static_cast<double>(count) / std::pow(side, 3); }
};

/// Two balls with much and with little room, and three cubes whose bulk has number densities of
/// about 0.19, 0.43 and 0.69.
inline std::vector<StatePoint> state_points(Profile const profile) {
    double const longer = profile == Profile::quick ? 1 : 20;
    auto const looks = static_cast<int>(3000 * longer);
    return {{2, 3, 400'000 * longer, 0, 16},
            {2, 2.2, 400'000 * longer, 0, 16},
            {200, 11, 3000 * longer, looks, 16},
            {500, 11, 2000 * longer, looks, 16},
            {1400, 13, 1000 * longer, looks, 16}};
}

/// What one replicate measures, with kT = 1. The first four are the density of centres where they
/// touch the walls, which is the pressure.
enum Value : std::size_t {
    by_impulse,      // given to the walls
    by_hits,         // their number
    by_profile,      // density against distance from a wall, extrapolated to contact
    over_the_middle, // the same over the middle of the faces
    bulk_density,    // in the middle of the cube
    collision_rate,  // of all balls with one another
    profile          // over the middle of the faces, bin by bin from here on
};

constexpr double edge_width = 2;   // of what is left out beside edges: the profile there is another
constexpr double wall_width = 2.5; // of what is not bulk beside walls
constexpr double reach = 0.3;      // beyond contact, where the extrapolation starts
constexpr int bins_of_reach = 30, bins_of_profile = 150;

inline Scene scene_of(StatePoint const& point, std::uint64_t const seed) {
    Scene scene;
    scene.system = {Boundary::walls, point.side, point.count, 1, 1};
    scene.arrangement = Arrangement::random;
    scene.seed = seed;
    return scene;
}

/// Value of a profile at contact: a polynomial of fourth degree leaves out less than 1e-3 of it.
inline double at_contact(DensityProfile const& profile) {
    return extrapolated(profile.distances(), profile.values(), 0.5, 4);
}

/// Time from one collision of a ball to its next, about.
inline double free_time(StatePoint const& point) {
    if (point.count == 2) return 1 / reference::TwoBalls{.side = point.side}.collision_rate();
    double const eta =
        std::numbers::pi / 6 * static_cast<double>(point.count) / std::pow(point.side - 1, 3);
    return 1 / (6 * std::numbers::inv_sqrtpi * (reference::carnahan_starling(eta) - 1));
}

inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(scene_of(point, seed));
    System const& system = engine->system();
    double const length = system.accessible_side();
    engine->advance({.time = 100 * free_time(point)});
    engine->start_clock();

    double const time = point.production * free_time(point);
    bool const many = point.looks > 0;
    DensityProfile near(system, 0.5 + (many ? reach : 0.1), bins_of_reach);
    DensityProfile near_middle(system, 0.5 + (many ? reach : 0.1), bins_of_reach,
                               many ? edge_width : 0);
    DensityProfile whole(system, many ? 3.5 : 0.6, bins_of_profile, many ? edge_width : 0);
    double density = 0;
    for (int look = 1; look <= point.looks; ++look) {
        engine->advance({.time = look * time / point.looks});
        Snapshot const shot = engine->snapshot();
        for (DensityProfile* eater : {&near, &near_middle, &whole}) eater->add(shot);
        density += density_in_the_middle(system, shot, point.side / 2 - wall_width) / point.looks;
    }
    engine->advance({.time = time});

    double const area = 6 * length * length;
    Tallies const& tallies = engine->tallies();
    double const kt = 2 * engine->kinetic_energy() / system.degrees_of_freedom();
    // Hits per area and time: density at contact times the mean of the speed towards the wall.
    double const towards = std::sqrt(kt / (2 * std::numbers::pi * system.mass)) *
                           reference::energy_shell_factor(system.degrees_of_freedom());
    Measurement values{tallies.wall_impulse / (time * area * kt),
                       static_cast<double>(tallies.wall_collisions) / (time * area * towards),
                       at_contact(near),
                       at_contact(near_middle),
                       density,
                       static_cast<double>(tallies.ball_collisions) / (time * std::sqrt(kt))};
    if (many)
        for (double const value : whole.values()) values.push_back(value);
    return values;
}

/// A pressure and what each term of theory adds up to, for a cube of many balls.
inline reference::WalledCubePressure theory_of(StatePoint const& point) {
    return reference::walled_cube_pressure(point.side, static_cast<double>(point.count));
}

/// Margin for two balls: four tenths of what walls off by 0.1 % do, and for the rate of collisions
/// two thirds of what such a diameter does.
constexpr double exact_margin(double const side) { return side < 2.5 ? 1e-3 : 5e-4; }
constexpr double exact_rate_margin = 2e-3;
/// For many: three times the error of theory, and less than half of what walls off by 0.1 % do to
/// the densest. Where contact values are extrapolated, several standard errors.
constexpr double margin = 3e-3;
constexpr double extrapolated_margin = 2e-2;
/// Relative error of the terms of theory together.
constexpr double theory_error = 1e-3;

/// Mean over replicates of one value less another.
inline Estimate difference(std::vector<Measurement> const& replicates, Value const value,
                           std::function<double(Measurement const&)> const& other) {
    std::vector<double> differences;
    for (Measurement const& replicate : replicates)
        differences.push_back(replicate[value] - other(replicate));
    return mean_of(differences);
}

inline void add_exact(Findings& findings, StatePoint const& point,
                      std::vector<Measurement> const& replicates) {
    reference::TwoBalls const exact{.side = point.side};
    double const pressure = exact.wall_pressure(), rate = exact.collision_rate();
    auto const add = [&](char const* name, char const* symbol, Value value, double expected,
                         double relative_margin) {
        findings.add({name,
                      symbol,
                      point.side,
                      {.measured = mean_of(replicates, value),
                       .reference = expected,
                       .margin = relative_margin * expected}});
    };
    add("two_balls_impulse", "2 balls, impulses", by_impulse, pressure, exact_margin(point.side));
    add("two_balls_hits", "2 balls, hits", by_hits, pressure, exact_margin(point.side));
    add("two_balls_collisions", "2 balls, collisions", collision_rate, rate, exact_rate_margin);
}

inline void add_cube(Findings& findings, StatePoint const& point,
                     std::vector<Measurement> const& replicates) {
    double const pressure = theory_of(point).total(), at = point.overall_density();
    auto const impulse = [](Measurement const& replicate) { return replicate[by_impulse]; };
    auto const bulk = [](Measurement const& replicate) {
        return reference::modified_klm_pressure(replicate[bulk_density]).value;
    };
    findings.add({"cube_impulse",
                  "$p$, impulses",
                  at,
                  {.measured = mean_of(replicates, by_impulse),
                   .reference = pressure,
                   .reference_error = theory_error * pressure,
                   .margin = margin * pressure}});
    findings.add(
        {"hits_minus_impulse",
         "hits $-$ impulses",
         at,
         {.measured = difference(replicates, by_hits, impulse), .margin = margin * pressure}});
    findings.add({"profile_minus_impulse",
                  "profile $-$ impulses",
                  at,
                  {.measured = difference(replicates, by_profile, impulse),
                   .margin = extrapolated_margin * pressure}});
    findings.add({"middle_minus_bulk",
                  "profile $-$ $P(\\rho_{\\mathrm b})$",
                  at,
                  {.measured = difference(replicates, over_the_middle, bulk),
                   .margin = extrapolated_margin * pressure}});
}

} // namespace clack::validation::wall_pressure
