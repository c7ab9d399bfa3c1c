#pragma once
// How balls between walls share their energy among the directions.

#include "validation/harness/ledger.hpp"
#include "validation/mutants/engine_maker.hpp"

#include <fmt/format.h>

namespace clack::validation::equipartition {

struct StatePoint {
    double packing_fraction;
    int count;
    int replicates;
    std::string text() const {
        return fmt::format("packing_fraction={} count={}", packing_fraction, count);
    }
};

inline std::vector<StatePoint> const state_points{{0.1, 100, 16}, {0.4, 100, 16}};

/// Shares of x, y and z in the energy, mean over looks about five collisions
/// of each ball apart.
inline Measurement measure(StatePoint const& point, std::uint64_t seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(
        parse_scene(fmt::format("container = {{boundary = \"walls\", packing_fraction = {}}}\n"
                                "balls = {{count = {}, arrangement = \"random\"}}\n"
                                "velocities = {{distribution = \"maxwell\", temperature = 1.0}}\n"
                                "run = {{seed = {}, collisions_per_ball = 1}}\n",
                                point.packing_fraction, point.count, seed),
                    "equipartition"));
    engine->advance({.ball_collisions = 2500}); // 50 a ball, to forget the start
    double const wait = engine->time() / 10;
    engine->start_clock();
    Eigen::Vector3d energy = Eigen::Vector3d::Zero();
    for (int look = 1; look <= 400; ++look) {
        engine->advance({.time = look * wait});
        energy += engine->snapshot().velocities.rowwise().squaredNorm();
    }
    energy /= energy.sum();
    return {energy[0], energy[1], energy[2]};
}

constexpr double margin = 0.01; // of a third

inline void enter(Ledger& ledger, StatePoint const& point,
                  std::vector<Measurement> const& replicates) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        ledger.compare(
            {cell(point.packing_fraction), std::string{"xyz"[axis]}}, {"share", "$E_x/E$"},
            {.measured = mean_of(replicates, axis), .reference = 1.0 / 3, .margin = margin / 3});
}

} // namespace clack::validation::equipartition
