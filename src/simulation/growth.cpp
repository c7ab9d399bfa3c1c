#include "simulation/growth.hpp"

#include "neighbours/cell_grid.hpp"
#include "neighbours/every_pair.hpp"
#include "resolution/growing_balls.hpp"
#include "scheduling/calendar.hpp"
#include "simulation/epoch.hpp"
#include "simulation/simulation.hpp"

#include <algorithm>
#include <random>

namespace clack {

namespace {

// Diameters per time in which a ball flies about one: quick enough to keep the liquid from
// crystallising, slow enough not to jam below the target.
constexpr double growth_rate = 0.25;
// The balls heat up as they grow, so they are cooled to their first temperature now and then.
constexpr double growth_per_stage = 1.02;
// At a packing fraction of 0.6 a stage takes some thirty collisions a ball; jammed balls go on for
// ever. They are then given more time, from where the stage began.
constexpr std::uint64_t jammed_collisions_per_ball = 1000;
constexpr double slowdown = 4;
constexpr double growth_rate_min = growth_rate / 256;

/// Velocity components of unit variance from sums of uniform numbers, which no mathematics library
/// has a say in.
Eigen::Matrix3Xd draw_velocities(Eigen::Index count, std::mt19937_64& random) {
    Eigen::Matrix3Xd velocities(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (int d = 0; d < 3; ++d) {
            double sum = -6;
            for (int k = 0; k < 12; ++k) sum += static_cast<double>(random() >> 11) * 0x1p-53;
            velocities(d, i) = sum;
        }
    }
    return velocities;
}

enum class Outcome { grown, jammed };

template <template <class> class Container, template <class, class> class Search>
Outcome grow_stage(System const& system, double widest, double rate, Start& balls) {
    using State = BallState<double, Container<double>>;
    GrowingBalls<double> const model{system.diameter, rate, widest};
    Simulation<double, Container, Search, Calendar, GrowingBalls> simulation(
        State(system, balls, epoch_length(system, 1)), model);
    Goal goal;
    goal.time = (widest - system.diameter) / rate;
    goal.ball_collisions = jammed_collisions_per_ball * static_cast<std::uint64_t>(system.count);
    if (simulation.advance(goal, NoObserver{}) != Stop::time) return Outcome::jammed;
    Snapshot shot = simulation.state().snapshot();
    balls = {std::move(shot.positions), std::move(shot.velocities)};
    return Outcome::grown;
}

Outcome grow_stage(System const& system, double widest, double rate, Start& balls) {
    if (system.boundary == Boundary::walls)
        return grow_stage<WalledCube, CellGrid>(system, widest, rate, balls);
    System wide = system;
    wide.diameter = widest;
    if (!CellGrid<double, PeriodicCube<double>>::fits(wide))
        return grow_stage<PeriodicCube, EveryPair>(system, widest, rate, balls);
    return grow_stage<PeriodicCube, CellGrid>(system, widest, rate, balls);
}

void cool(Eigen::Matrix3Xd& velocities) {
    double square_sum = 0;
    for (Eigen::Index i = 0; i < velocities.cols(); ++i)
        square_sum += dot<double>(velocities.col(i), velocities.col(i));
    velocities *= std::sqrt(3 * static_cast<double>(velocities.cols()) / square_sum);
}

} // namespace

Eigen::Matrix3Xd grow_balls(System const& target, Eigen::Matrix3Xd const& positions,
                            double start_diameter, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Start balls{positions, draw_velocities(positions.cols(), random)};
    // A hair more than asked for, so that none overlap at the diameter itself.
    double const final_diameter = target.diameter * (1 + 0x1p-40);
    System system = target;
    system.diameter = start_diameter;
    double rate = growth_rate;
    while (system.diameter < final_diameter) {
        double const widest = std::min(system.diameter * growth_per_stage, final_diameter);
        cool(balls.velocities);
        if (grow_stage(system, widest, rate, balls) == Outcome::grown) {
            system.diameter = widest;
        } else if ((rate /= slowdown) < growth_rate_min) {
            throw LawBroken(
                fmt::format("the balls jam while they grow, at a packing fraction of {:.4f}",
                            system.packing_fraction()));
        }
    }
    return balls.positions;
}

} // namespace clack
