#include "reference/frame_stepping.hpp"
#include "reference/triangle_wave.hpp"
#include "tests/made_up_balls.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace clack;
using clack::reference::FrameStepping;

namespace {

Start two_balls() {
    Start start;
    start.positions.resize(3, 2);
    start.velocities.resize(3, 2);
    start.positions << 2, 5, 3, 3.3, 3, 3;
    start.velocities << 1, -0.5, 0, 0, 0.2, 0.2;
    return start;
}

/// Largest distance between the places of frames and of the engine.
double error(System const& system, Start const& start, double const time, int const steps) {
    FrameStepping frames(system, start, time / steps);
    frames.advance(steps);
    auto const engine = make_engine(system, Method::table, Precision::double_, start);
    engine->advance({.time = time});
    return (frames.balls().positions - engine->snapshot().positions).colwise().norm().maxCoeff();
}

} // namespace

BOOST_AUTO_TEST_CASE(a_collision_errs_by_the_first_order_of_the_step) {
    System const system{.side = 8, .count = 2};
    // 1.3 times the steps, again and again: where in a step the pair touches averages out.
    double coarse = 0, fine = 0;
    for (int const steps : {50, 65, 84, 110}) {
        coarse += error(system, two_balls(), 2.5, steps);
        fine += error(system, two_balls(), 2.5, 16 * steps);
    }
    BOOST_TEST(coarse > 0.01);
    BOOST_TEST(coarse / fine > 8);
    BOOST_TEST(coarse / fine < 32);
}

BOOST_AUTO_TEST_CASE(walls_are_exact) {
    System const system{.side = 4, .count = 1};
    Start start;
    start.positions = Eigen::Vector3d(1, 2, 3);
    start.velocities = Eigen::Vector3d(0.7, -1.1, 0.3);
    FrameStepping frames(system, start, 0.1);
    frames.advance(500);
    for (int d = 0; d < 3; ++d) {
        reference::TriangleWave const wave(3, start.positions(d) - 0.5, start.velocities(d));
        BOOST_TEST(std::abs(frames.balls().positions(d) - 0.5 - wave.position(50)) < 1e-11);
    }
    BOOST_TEST(frames.tallies().wall_collisions > 20);
}

BOOST_AUTO_TEST_CASE(energy_and_momentum_are_kept_and_nothing_stays_deep_in_another) {
    System const system = made_up::system(Boundary::periodic, 108, 0.2);
    Start const start = made_up::lattice(system, 2015);
    FrameStepping frames(system, start, 0.002);
    frames.advance(1000);
    Start const& now = frames.balls();
    double const energy = start.velocities.squaredNorm();
    BOOST_TEST(frames.tallies().ball_collisions > 100);
    BOOST_TEST(frames.pairs().size() == frames.tallies().ball_collisions);
    BOOST_TEST(std::abs(now.velocities.squaredNorm() / energy - 1) < 1e-12);
    BOOST_TEST(now.velocities.rowwise().sum().norm() < 1e-11);
    BOOST_TEST(now.positions.minCoeff() > -0.1); // pushed over the edge, until the next step
    BOOST_TEST(now.positions.maxCoeff() < system.side + 0.1);
    BOOST_TEST(frames.tallies().deepest_overlap > 0);
    BOOST_TEST(frames.tallies().deepest_overlap < 0.05); // a few steps of the fastest
}

BOOST_AUTO_TEST_CASE(frames_follow_the_engine_for_a_while) {
    System const system = made_up::system(Boundary::walls, 64, 0.1);
    Start const start = made_up::lattice(system, 7);
    BOOST_TEST(error(system, start, 0.5, 40'000) < 0.02);
}

BOOST_AUTO_TEST_CASE(narrow_cube_is_one_cell) {
    System const system{.side = 2.8, .count = 2};
    Start start;
    start.positions.resize(3, 2);
    start.velocities = Eigen::Matrix3Xd::Zero(3, 2);
    start.positions << 0.8, 2.2, 1, 1.1, 1, 1;
    start.velocities(0, 0) = 1;
    double coarse = error(system, start, 1, 100), fine = error(system, start, 1, 10'000);
    BOOST_TEST(fine < 1e-3);
    BOOST_TEST(fine < coarse);
}

BOOST_AUTO_TEST_CASE(step_that_is_none_is_refused) {
    BOOST_CHECK_THROW(FrameStepping({.side = 8, .count = 2}, two_balls(), 0),
                      std::invalid_argument);
}
