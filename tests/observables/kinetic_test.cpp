#include "observables/encounter.hpp"
#include "observables/free_flights.hpp"
#include "observables/helfand_moments.hpp"
#include "observables/self_correlation.hpp"
#include "tests/made_up_balls.hpp"

#include <boost/test/unit_test.hpp>

using namespace clack;
namespace tools = boost::test_tools;

namespace {

Collision<double> ball_collision(double time, std::int64_t first, std::int64_t second,
                                 Eigen::Vector3d velocity_first, Eigen::Vector3d velocity_second) {
    Collision<double> collision{};
    collision.kind = CollisionKind::ball;
    collision.time = time;
    collision.first = first;
    collision.second = second;
    collision.velocity_first = velocity_first;
    collision.velocity_second = velocity_second;
    collision.separation = {0, 0, 2};
    return collision;
}

} // namespace

BOOST_AUTO_TEST_CASE(encounter_tells_speed_along_and_distance_across_the_line_of_centres) {
    auto const met = encounter_of(ball_collision(0, 0, 1, {0, 0, -1}, {4, 0, 2}));
    BOOST_TEST(met.normal_speed == 3);
    BOOST_TEST(met.impact_parameter_squared == 16.0 / 25, tools::tolerance(1e-15));
    BOOST_TEST(met.line_of_centres[2] == 1);
}

BOOST_AUTO_TEST_CASE(flight_goes_from_one_collision_of_a_ball_to_its_next) {
    FreeFlights watch(3);
    watch(ball_collision(1, 0, 1, {3, 4, 0}, {0, 0, 1}));
    BOOST_TEST(watch.flights().empty()); // where these flights began is not known
    Collision<double> wall = ball_collision(2, 0, 5, {-3, 4, 0}, {0, 0, 0});
    wall.kind = CollisionKind::wall;
    watch(wall);
    BOOST_TEST(watch.flights().empty());
    watch(ball_collision(4, 0, 2, {1, 0, 0}, {0, 2, 0}));
    BOOST_REQUIRE_EQUAL(watch.flights().size(), 1);
    BOOST_TEST(watch.flights()[0].time == 3);
    BOOST_TEST(watch.flights()[0].length == 15);
    watch.forget();
    watch(ball_collision(6, 1, 2, {1, 0, 0}, {0, 2, 0}));
    BOOST_REQUIRE_EQUAL(watch.flights().size(), 2);
    BOOST_TEST(watch.flights()[0].length == 5);
    BOOST_TEST(watch.flights()[1].length == 4);
}

BOOST_AUTO_TEST_CASE(steady_flight_through_a_periodic_cube_goes_ever_farther) {
    constexpr double side = 2;
    SelfCorrelation correlation(side, 4, 2);
    for (int k = 0; k < 12; ++k) { // 1.5 sides an interval, along x
        Snapshot shot;
        shot.positions = Eigen::Matrix3Xd::Zero(3, 2);
        shot.velocities = Eigen::Matrix3Xd::Zero(3, 2);
        shot.images = Eigen::Matrix3Xi::Zero(3, 2);
        shot.positions(0, 0) = k % 2 == 0 ? 0 : 1;
        shot.images(0, 0) = 3 * k / 2;
        shot.velocities(0, 0) = 3;
        shot.velocities(1, 1) = k % 2 == 0 ? 1 : -1;
        correlation.add(shot);
    }
    BOOST_TEST(correlation.mean_square_displacement(0) == 0);
    BOOST_TEST(correlation.mean_square_displacement(4) == 12 * 12 / 2.0); // over both balls
    BOOST_TEST(correlation.velocity_autocorrelation(3) == (9 - 1) / 2.0);
    BOOST_TEST(correlation.velocity_autocorrelation(4) == (9 + 1) / 2.0);
}

BOOST_AUTO_TEST_CASE(helfand_moments_are_of_positions_that_are_never_wrapped) {
    // Summed over the balls, x v grows by stress and x e by heat: in a box with walls that no ball
    // reaches, both sides are known from two snapshots.
    System const system = made_up::system(Boundary::walls, 32, 0.001);
    Start start = made_up::lattice(made_up::system(Boundary::periodic, 32, 0.3), 7);
    start.positions.colwise() +=
        Eigen::Vector3d::Constant(system.side / 2) - start.positions.rowwise().mean();
    auto const engine = make_engine(system, Method::automatic, Precision::double_, start);
    auto const moments_of = [&](Snapshot const& shot) {
        Eigen::Matrix3d stress = shot.positions * shot.velocities.transpose();
        Eigen::Vector3d heat =
            shot.positions * shot.velocities.colwise().squaredNorm().transpose() / 2;
        return std::pair(stress, heat);
    };
    Snapshot const before = engine->snapshot();
    HelfandMoments moments(system, before);
    engine->advance({.time = 2}, &moments);
    BOOST_REQUIRE(engine->tallies().wall_collisions == 0);
    BOOST_REQUIRE(engine->tallies().ball_collisions > 10);
    auto const [stress_before, heat_before] = moments_of(before);
    auto const [stress_after, heat_after] = moments_of(engine->snapshot());
    BOOST_TEST((moments.stress(2) - (stress_after - stress_before)).norm() < 1e-10);
    BOOST_TEST((moments.heat(2) - (heat_after - heat_before)).norm() < 1e-10);
}
