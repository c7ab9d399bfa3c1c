#pragma once
// How a gas forgets its start: state points, one measurement, and what it should give.

#include "reference/kac_walk.hpp"
#include "reference/velocity_laws.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/lattice_start.hpp"
#include "validation/mutants/engine_maker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace clack::validation::relaxation {

enum class Begin { equal_speeds, one_moving, two_halves };
constexpr char const* name_of(Begin const begin) {
    return begin == Begin::equal_speeds ? "equal_speeds"
           : begin == Begin::one_moving ? "one_moving"
                                        : "two_halves";
}

constexpr std::int64_t ball_count = 256;

/// A gas between walls, so dilute that a ball crosses the cube many times before it meets another:
/// then only velocities matter, and the walk of Kac is its law. kT = 1 at the end.
struct StatePoint {
    Begin begin;
    int replicates;
    int walks; // of the reference
    /// Mean free path 10 sides; but 37 where two halves must mix before balls meet.
    double number_density() const { return begin == Begin::two_halves ? 3e-5 : 2e-4; }

    double side() const { return std::cbrt(static_cast<double>(ball_count) / number_density()); }
    double mean_free_time() const {
        return 1 / (4 * std::sqrt(std::numbers::pi) * number_density());
    }
    std::string text() const { return fmt::format("{} count={}", name_of(begin), ball_count); }
};

inline std::vector<StatePoint> state_points(Profile const profile) {
    bool const quick = profile == Profile::quick;
    std::vector<StatePoint> points;
    for (Begin const begin : {Begin::equal_speeds, Begin::one_moving, Begin::two_halves})
        points.push_back({begin, quick ? (begin == Begin::two_halves ? 200 : 240) : 6000,
                          quick ? 2000 : 40'000});
    return points;
}

/// When one looks, in mean free times of the end.
inline std::vector<double> looks() { return {0.4, 0.6, 0.8, 1, 1.25, 1.5, 2, 2.5, 3, 4, 5}; }

/// Velocities of a start; balls on the left (x first) are the first half.
inline Eigen::Matrix3Xd velocities(Begin const begin, std::int64_t const count,
                                   std::uint64_t const seed) {
    std::mt19937_64 random(seed);
    auto const normal = [&] { // Box and Muller
        return std::sqrt(-2 * std::log1p(-uniform(random))) *
               std::cos(2 * std::numbers::pi * uniform(random));
    };
    Eigen::Matrix3Xd drawn(3, count);
    for (Eigen::Index k = 0; k < count; ++k) {
        for (double& component : drawn.col(k)) component = normal();
        if (begin == Begin::equal_speeds) drawn.col(k).normalize();
        if (begin == Begin::one_moving && k > 0) drawn.col(k).setZero();
        if (begin == Begin::two_halves && k >= count / 2) drawn.col(k) /= 4; // 16 times colder
    }
    return drawn * std::sqrt(3 * static_cast<double>(count) / drawn.squaredNorm());
}

inline Scene scene_of(StatePoint const& point, std::uint64_t const seed) {
    Scene scene;
    scene.system.count = ball_count;
    scene.system.side = point.side();
    scene.arrangement = Arrangement::random;
    scene.seed = seed;
    Eigen::Matrix3Xd places = make_start(scene).positions;
    std::vector<Eigen::Index> order;
    for (Eigen::Index k = 0; k < ball_count; ++k) order.push_back(k);
    if (point.begin == Begin::two_halves)
        std::sort(order.begin(), order.end(),
                  [&](Eigen::Index a, Eigen::Index b) { return places(0, a) < places(0, b); });
    scene.arrangement = Arrangement::explicit_;
    scene.positions = places(Eigen::all, order);
    scene.distribution = Distribution::explicit_;
    scene.velocities = velocities(point.begin, ball_count, seed);
    return scene;
}

/// Bins of speed that are equally probable at the end.
constexpr std::size_t bin_count = 24;
inline std::vector<double> bin_edges() {
    System system;
    system.count = ball_count;
    reference::VelocityLaw const law(system, 1.5 * static_cast<double>(system.count));
    std::vector<double> edges;
    for (std::size_t k = 1; k < bin_count; ++k)
        edges.push_back(law.speed_quantile(static_cast<double>(k) / bin_count));
    return edges;
}

/// Boltzmann's H above that of the end, per ball: sum over bins of p ln(p / p at the end). Finitely
/// many balls leave about (bins - 1) / (2 n) of it at the end.
inline double excess_h(Eigen::Matrix3Xd const& balls, std::vector<double> const& edges) {
    std::vector<double> share(bin_count);
    for (auto const& velocity : balls.colwise()) {
        auto const bin = std::upper_bound(edges.begin(), edges.end(), velocity.norm());
        share[static_cast<std::size_t>(bin - edges.begin())] +=
            1 / static_cast<double>(balls.cols());
    }
    double sum = 0;
    for (double const p : share)
        if (p > 0) sum += p * std::log(p * bin_count);
    return sum;
}

/// Collisions per ball so far and excess of H, look by look, of a gas or of a walk.
template <class Gas, class Collisions, class Velocities>
Measurement follow(StatePoint const& point, Gas&& advance, Collisions&& collisions,
                   Velocities&& balls) {
    static std::vector<double> const edges = bin_edges();
    Measurement values;
    for (double const look : looks()) {
        advance(look * point.mean_free_time());
        values.push_back(2 * static_cast<double>(collisions()) / static_cast<double>(ball_count));
        values.push_back(excess_h(balls(), edges));
    }
    return values;
}

inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(scene_of(point, seed));
    return follow(
        point, [&](double const time) { engine->advance({.time = time}); },
        [&] { return engine->tallies().ball_collisions; },
        [&] { return engine->snapshot().velocities; });
}

inline Measurement walk(StatePoint const& point, std::uint64_t const seed) {
    System const system{Boundary::walls, point.side(), ball_count, 1, 1};
    reference::KacWalk kac(velocities(point.begin, ball_count, seed),
                           reference::walled_pair_rate(1, system.accessible_side()),
                           reference::KacWalk::Momentum::reflected, seed + 1);
    return follow(
        point, [&](double const time) { kac.advance(time); }, [&] { return kac.collisions(); },
        [&] { return kac.velocities(); });
}

/// Margins, as parts of what H has to lose from the first look on and of the collisions: a
/// relaxation a tenth too fast or too slow would not pass.
constexpr double excess_margin = 0.04, collisions_margin = 0.05;

/// Enters what the replicates of a start say beside the walks.
inline void enter(Ledger& ledger, StatePoint const& point, std::vector<Measurement> const& gas,
                  std::vector<Measurement> const& walks) {
    double const margin = excess_margin * mean_of(walks, 1).value;
    double rise = 0; // the largest, in standard errors
    for (std::size_t look = 0; look < looks().size(); ++look) {
        std::vector<std::string> const state{name_of(point.begin),
                                             fmt::format("{}", looks()[look])};
        Estimate const theory = mean_of(walks, 2 * look + 1), met = mean_of(walks, 2 * look);
        Estimate const h = mean_of(gas, 2 * look + 1);
        ledger.compare(state, {"excess_H", "$H-H_\\infty$"},
                       {{}, h, theory.value, theory.error, margin});
        if (looks()[look] >= 2)
            ledger.compare(
                state, {"collisions_per_ball", "collisions"},
                {{}, mean_of(gas, 2 * look), met.value, met.error, collisions_margin * met.value});
        if (look == 0) continue;
        std::vector<double> steps;
        for (Measurement const& values : gas)
            steps.push_back(values[2 * look + 1] - values[2 * look - 1]);
        Estimate const step = mean_of(steps);
        if (step.error > 0) rise = std::max(rise, step.value / step.error);
    }
    double const steps = static_cast<double>(looks().size() - 1);
    double const p = steps * upper_tail(rise, static_cast<double>(gas.size() - 1));
    ledger.fit({name_of(point.begin), ""}, {"H_never_rises", "$H$ never rises"}, std::min(1.0, p));
}

} // namespace clack::validation::relaxation
