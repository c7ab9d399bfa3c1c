#include "reference/one_ball.hpp"
#include "reference/triangle_wave.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace clack;
using namespace clack::reference;

BOOST_AUTO_TEST_CASE(point_returns_after_a_period) {
    TriangleWave const wave(3, 1, -0.75);
    double const period = 2 * 3 / 0.75;
    for (double const t : {0.0, 0.5, 2.0, 7.9}) {
        BOOST_TEST(std::abs(wave.position(t + 1000 * period) - wave.position(t)) < 1e-12);
        BOOST_TEST(wave.velocity(t + 1000 * period) == wave.velocity(t));
        BOOST_TEST(wave.hits(t + 1000 * period) == wave.hits(t) + 2000);
    }
}

BOOST_AUTO_TEST_CASE(point_moves_as_followed_by_hand) {
    TriangleWave const wave(2, 0.5, 1); // hits 2 at t = 1.5, 0 at 3.5, 2 at 5.5
    BOOST_TEST(wave.position(1) == 1.5);
    BOOST_TEST(wave.hits(1.4) == 0);
    BOOST_TEST(wave.hits(1.5) == 1);
    BOOST_TEST(wave.velocity(1.5) == -1);
    BOOST_TEST(wave.position(2) == 1.5);
    BOOST_TEST(wave.hits(3.5) == 2);
    BOOST_TEST(wave.velocity(3.6) == 1);
    BOOST_TEST(wave.position(4.5) == 1);
    BOOST_TEST(wave.hits(5.5) == 3);
}

BOOST_AUTO_TEST_CASE(point_that_moves_left_is_the_mirror_image) {
    TriangleWave const right(2, 0.5, 1), left(2, 1.5, -1);
    for (double t = 0; t < 20; t += 0.3) {
        BOOST_TEST(std::abs(left.position(t) - (2 - right.position(t))) < 1e-14);
        BOOST_TEST(left.hits(t) == right.hits(t));
        BOOST_TEST(left.velocity(t) == -right.velocity(t));
    }
}

BOOST_AUTO_TEST_CASE(point_at_rest_stays) {
    TriangleWave const wave(2, 0.5, 0);
    BOOST_TEST(wave.position(1e9) == 0.5);
    BOOST_TEST(wave.hits(1e9) == 0);
}

BOOST_AUTO_TEST_CASE(point_outside_the_mirrors_is_refused) {
    BOOST_CHECK_THROW(TriangleWave(2, 2.1, 1), std::invalid_argument);
    BOOST_CHECK_THROW(TriangleWave(0, 0, 1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(marks_are_counted_on_both_ways) {
    BOOST_TEST(marks_passed(0.5L, 3, 1) == 3);
    BOOST_TEST(marks_passed(0.5L, -3, 1) == 3);
    BOOST_TEST(marks_passed(1, 1, 1) == 1);  // the mark at the start is passed already
    BOOST_TEST(marks_passed(1, -1, 1) == 1); // the one at the end is reached
    BOOST_TEST(marks_passed(0.25L, 0.5L, 1) == 0);
    BOOST_TEST(marks_passed(0.25L, -0.5L, 1) == 1);
}

BOOST_AUTO_TEST_CASE(one_ball_moves_along_each_axis_alone) {
    System const system{.side = 4, .count = 1, .diameter = 1, .mass = 2};
    OneBall const ball(system, {1, 2, 3}, {0.25, -1, 0});
    BOOST_TEST(ball.position(2)[0] == 1.5);
    BOOST_TEST(ball.position(2)[1] == 1); // turned at y = 0.5, t = 1.5
    BOOST_TEST(ball.position(2)[2] == 3);
    BOOST_TEST(ball.velocity(2)[1] == 1);
    BOOST_TEST(ball.wall_collisions(2) == 1);
    BOOST_TEST(ball.wall_collisions(24) == 8 + 2); // y: every 3 from 1.5; x: at 10, then 22
    BOOST_TEST(std::abs(ball.mean_wall_force()[1] - 2.0 / 3) < 1e-15);
    BOOST_TEST(ball.mean_wall_force()[2] == 0);
    BOOST_CHECK_THROW(OneBall(system, {0.4, 2, 2}, {1, 0, 0}), std::invalid_argument);
}
