#pragma once
// Balls on a line: state points, one measurement, and what it should give.

#include "reference/ghost_chain.hpp"
#include "reference/triangle_wave.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/lattice_start.hpp"
#include "validation/mutants/engine_maker.hpp"
#include "validation/statistics/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace clack::validation::tonks_gas {

/// So many balls whose centres lie on one line between two walls.
struct StatePoint {
    std::int64_t count;
    double side; // wall to wall, in diameters
    Precision precision;
    int replicates;

    double roundoff() const { return precision == Precision::single_ ? 0x1p-24 : 0x1p-53; }
    /// Room of the ghosts: what the balls leave.
    double free_length() const { return side - static_cast<double>(count); }
    std::string text() const {
        return fmt::format("count={} side={} roundoff={}", count, side, roundoff());
    }
};

inline std::vector<StatePoint> state_points(Profile const profile) {
    int const replicates = profile == Profile::quick ? 8 : 64;
    return {{10, 20, Precision::single_, replicates},
            {10, 20, Precision::double_, replicates},
            {100, 160, Precision::double_, replicates}};
}

/// When the balls are looked at: at 2^0 ... 2^12, and a golden section later. Starts in fractions
/// of two would now and then have a collision at a time that is one, and rounding would say whether
/// it has been; to this number no ratio of theirs comes near enough.
constexpr int look_count = 13;
inline double look_time(int const look) { return std::ldexp(1.0, look) + std::numbers::phi - 1; }

/// Makes an engine from a system, a precision and a start.
using ChainMaker =
    std::function<std::unique_ptr<Engine>(System const&, Precision, Start const& start)>;
inline std::unique_ptr<Engine> make_true_chain(System const& system, Precision const precision,
                                               Start const& start) {
    return make_engine(system, Method::automatic, precision, start);
}

/// Balls thrown at random onto the line, in numbers that every precision holds exactly. None
/// touches another or a wall: what collides at time 0 does so in the engine, and not among the
/// ghosts.
struct Chain {
    System system;
    Start start;
    std::vector<double> places, speeds; // from left to right

    Chain(StatePoint const& point, std::uint64_t const seed) {
        system.count = point.count;
        system.side = point.side;
        std::mt19937_64 random(seed);
        auto const exact = [](double const x) { return std::round(x * 0x1p14) / 0x1p14; };
        auto const is_free = [&](double const place) {
            return place > 0 && place < point.free_length() &&
                   std::find(places.begin(), places.end(), place) == places.end();
        };
        for (std::int64_t k = 0; k < point.count; ++k) {
            double place = 0;
            while (!is_free(place)) place = exact(uniform(random, 0, point.free_length()));
            places.push_back(place);
            double normal = -6; // nearly, from twelve
            for (int draw = 0; draw < 12; ++draw) normal += uniform(random);
            speeds.push_back(exact(normal));
        }
        std::sort(places.begin(), places.end());
        start.positions = Eigen::Matrix3Xd::Constant(3, point.count, point.side / 2);
        start.velocities = Eigen::Matrix3Xd::Zero(3, point.count);
        for (Eigen::Index k = 0; k < point.count; ++k) {
            auto const i = static_cast<std::size_t>(k);
            places[i] += static_cast<double>(k) + 0.5;
            start.positions(0, k) = places[i];
            start.velocities(0, k) = speeds[i];
        }
    }
};

/// What one look tells.
enum Value : std::size_t {
    collisions_per_ball,
    place_error, // of the ball farthest from where it should be [diameter]
    missed,      // difference of the numbers of collisions from the exact ones
    hit_error,   // momentum given to the walls beside the ghosts', relative
    wall_excess, // of the mean force on a wall over Tonks's, minus 1
    wall_bound,  // how large that may be: each ghost hits at most once more or less
    virial_excess,
    virial_bound,
    value_count
};

/// Momentum that the ghosts give to both walls.
inline double ghost_impulse(StatePoint const& point, Chain const& chain, double const time) {
    double impulse = 0;
    for (std::size_t i = 0; i < chain.speeds.size(); ++i) {
        reference::TriangleWave const ghost(
            point.free_length(), chain.places[i] - static_cast<double>(i) - 0.5, chain.speeds[i]);
        impulse += 2 * std::abs(chain.speeds[i]) * static_cast<double>(ghost.hits(time));
    }
    return impulse;
}

inline void look(Measurement& values, StatePoint const& point, Chain const& chain,
                 reference::GhostChain const& ghosts, Engine const& engine) {
    double const time = engine.time();
    auto const count = static_cast<double>(point.count);
    double energy2 = 0, sum = 0; // of |v|
    for (double const speed : chain.speeds) {
        energy2 += speed * speed;
        sum += std::abs(speed);
    }
    Snapshot const shot = engine.snapshot();
    auto const exact = ghosts.positions(time);
    double worst = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
        worst = worse(worst, std::abs(shot.positions(0, static_cast<Eigen::Index>(i)) - exact[i]));
    Tallies const& tallies = engine.tallies();
    auto const balls = static_cast<double>(ghosts.ball_collisions(time));
    auto const walls = static_cast<double>(ghosts.wall_collisions(time));
    double const missed = std::abs(static_cast<double>(tallies.ball_collisions) - balls) +
                          std::abs(static_cast<double>(tallies.wall_collisions) - walls);
    double const impulse = ghost_impulse(point, chain, time);
    double const force = energy2 / point.free_length(); // Tonks
    // Virial theorem between walls, about their middle: its boundary term is the change of
    // the sum of x v, at most side/2 times the speeds at either end.
    double const virial = force * (count - 1);
    values.insert(values.end(),
                  {2 * balls / count, worst, missed,
                   (tallies.wall_impulse - impulse) / std::max(impulse, sum),
                   tallies.wall_impulse / (2 * time) / force - 1, sum / (time * force),
                   tallies.virial / time / virial - 1, (2 * sum * point.side) / (time * virial)});
}

inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           ChainMaker const& make = make_true_chain) {
    Chain const chain(point, seed);
    reference::GhostChain const ghosts(point.side, 1, chain.places, chain.speeds);
    auto const engine = make(chain.system, point.precision, chain.start);
    Measurement values;
    for (int k = 0; k < look_count; ++k) {
        engine->advance({.time = look_time(k)});
        look(values, point, chain, ghosts, *engine);
    }
    return values;
}

/// How far rounding may take a ball. A collision rounds a place, and its instant by as much as
/// moves a ball by a rounding of its place. A chain is not chaotic, so that these add up, at worst
/// all to one side. Velocities in fractions of two are swapped exactly, all but always; once one is
/// not, every collision rounds it, up or down: after k of them it is off by as much as the root of
/// k roundings, and its ball by the sum of that over k free paths. Of this, sixteen standard
/// errors.
inline double place_bound(StatePoint const& point, double const collisions) {
    double const free_path = point.free_length() / static_cast<double>(point.count);
    double const to_one_side = 4 * point.side * (1 + collisions);
    double const up_or_down = 16 * free_path * std::sqrt(std::pow(collisions, 3) / 3);
    return point.roundoff() * (to_one_side + up_or_down);
}

inline void enter(Ledger& ledger, StatePoint const& point,
                  std::vector<Measurement> const& replicates) {
    double place = 0, lost = 0, hit = 0, wall = 0, virial = 0;
    auto const take = [](double& worst, double const value) {
        worst = worse(worst, std::abs(value));
    };
    for (Measurement const& values : replicates) {
        for (int k = 0; k < look_count; ++k) {
            double const* const seen = &values.at(static_cast<std::size_t>(k) * value_count);
            take(place, seen[place_error] / place_bound(point, seen[collisions_per_ball]));
            take(lost, seen[missed]);
            take(hit, seen[hit_error]);
            take(wall, seen[wall_excess] / seen[wall_bound]);
            take(virial, seen[virial_excess] / seen[virial_bound]);
        }
    }
    bool const coarse = point.precision == Precision::single_;
    std::vector<std::string> const state{cell(point.count), coarse ? "float" : "double"};
    ledger.bound(state, {"place", "$\\max|x-x_{\\text{ghost}}|$ / bound"}, place, 0, 1);
    ledger.bound(state, {"wall_force", "$|F - F_{\\text{Tonks}}|$ / bound"}, wall, 0, 1);
    ledger.bound(state, {"virial", "$|W - W_{\\text{Tonks}}|$ / bound"}, virial, 0, 1);
    if (coarse) return; // its balls are too far off in time for every collision to be before a look
    ledger.bound(state, {"collisions", "collisions missed"}, lost, 0, 0);
    ledger.bound(state, {"wall_impulse", "momentum to walls, relative error"}, hit, 0, 1e-12);
}

} // namespace clack::validation::tonks_gas
