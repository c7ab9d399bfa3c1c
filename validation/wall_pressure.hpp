#pragma once
// Pressure on the walls of a cube: state points, one measurement, and what it should give.

#include "observables/density_profile.hpp"
#include "observables/pressure.hpp"
#include "observables/radial_distribution.hpp"
#include "reference/equation_of_state.hpp"
#include "reference/finite_size.hpp"
#include "reference/two_balls.hpp"
#include "reference/walled_fluid.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/mutants/engine_maker.hpp"

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
    int replicates = 16;

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
    return {{2, 3, 400'000 * longer, 0},
            {2, 2.2, 400'000 * longer, 0},
            {200, 11, 3000 * longer, looks},
            {500, 11, 2000 * longer, looks},
            {1400, 13, 1000 * longer, looks}};
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

/// Margins as parts of the pressure. For two balls four tenths of what walls off by 0.1 % do, and
/// for the rate of collisions two thirds of what such a diameter does. For many three times the
/// error of theory, and less than half of what walls off by 0.1 % do to the densest. Where contact
/// values are extrapolated, several standard errors. These are four times smaller in the full
/// profile, and so are what two balls are allowed, and half of what extrapolation is.
struct Margins {
    double two_balls = 5e-4, two_with_little_room = 1e-3, two_collisions = 2e-3;
    double many = 3e-3, extrapolated = 2e-2;
};
constexpr Margins margins(Profile const profile) {
    if (profile == Profile::quick) return {};
    return {.two_balls = 1.25e-4,
            .two_with_little_room = 2.5e-4,
            .two_collisions = 5e-4,
            .extrapolated = 1e-2};
}
constexpr double theory_error = 1e-3; // relative, of the terms of theory together

inline void enter_two(Ledger& ledger, StatePoint const& point,
                      std::vector<Measurement> const& replicates, Margins const& margins) {
    reference::TwoBalls const exact{.side = point.side};
    double const margin = point.side < 2.5 ? margins.two_with_little_room : margins.two_balls;
    auto const add = [&](Quantity const& quantity, Value value, double expected, double part) {
        ledger.compare({cell(point.side)}, quantity,
                       {.measured = mean_of(replicates, value),
                        .reference = expected,
                        .margin = part * expected});
    };
    add({"two_balls_impulse", "2 balls, impulses"}, by_impulse, exact.wall_pressure(), margin);
    add({"two_balls_hits", "2 balls, hits"}, by_hits, exact.wall_pressure(), margin);
    add({"two_balls_collisions", "2 balls, collisions"}, collision_rate, exact.collision_rate(),
        margins.two_collisions);
}

inline void enter_many(Ledger& ledger, StatePoint const& point,
                       std::vector<Measurement> const& replicates, Margins const& margins) {
    double const pressure = theory_of(point).total();
    std::vector<std::string> const state{fmt::format("{:.4g}", point.overall_density())};
    ledger.compare(state, {"cube_impulse", "$p$, impulses"},
                   {.measured = mean_of(replicates, by_impulse),
                    .reference = pressure,
                    .reference_error = theory_error * pressure,
                    .margin = margins.many * pressure});
    auto const add = [&](Quantity const& quantity, auto const& difference, double const part) {
        ledger.compare(state, quantity,
                       {.measured = mean_of(replicates, difference), .margin = part * pressure});
    };
    auto const less_impulse = [](Value const value) {
        return [=](Measurement const& m) { return m[value] - m[by_impulse]; };
    };
    add({"hits_minus_impulse", "hits $-$ impulses"}, less_impulse(by_hits), margins.many);
    add({"profile_minus_impulse", "profile $-$ impulses"}, less_impulse(by_profile),
        margins.extrapolated);
    add(
        {"middle_minus_bulk", "profile $-$ $P(\\rho_{\\mathrm b})$"},
        [](Measurement const& m) {
            return m[over_the_middle] - reference::modified_klm_pressure(m[bulk_density]).value;
        },
        margins.extrapolated);
}

inline void enter(Ledger& ledger, StatePoint const& point,
                  std::vector<Measurement> const& replicates, Margins const& margins) {
    point.count == 2 ? enter_two(ledger, point, replicates, margins)
                     : enter_many(ledger, point, replicates, margins);
}

} // namespace clack::validation::wall_pressure
