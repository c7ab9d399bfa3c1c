#include "prediction/wall.hpp"
#include "tests/made_up_balls.hpp"

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

using namespace clack;
using Reals = boost::mpl::list<float, double, long double, quad>;

BOOST_AUTO_TEST_CASE_TEMPLATE(ball_stands_on_the_plane_when_it_hits, Real, Reals) {
    std::mt19937_64 random(1);
    WalledCube<Real> const cube(System{.side = 10});
    for (int k = 0; k < 2000; ++k) {
        Ball<Real> ball{};
        ball.point = made_up::in_cube<Real>(random, 0.5, 9.5);
        ball.velocity = made_up::in_cube<Real>(random, -1, 1);
        ball.time = static_cast<Real>(made_up::uniform(random));
        auto const hit = earliest_wall(ball, cube);
        BOOST_TEST_REQUIRE((hit.time >= ball.time));
        int const d = hit.wall / 2;
        Real const plane = hit.wall % 2 == 0 ? cube.low : cube.high;
        using std::abs;
        Real const speed = abs(ball.velocity[d]) * hit.time;
        Real const off = ball.position(hit.time)[d] - plane;
        BOOST_TEST_REQUIRE((abs(off) <= 8 * unit_roundoff<Real> * (10 + speed)));
        for (int other = 0; other < 3; ++other) {
            Real const place = ball.position(hit.time)[other];
            BOOST_TEST_REQUIRE((place > cube.low - Real(1e-4) && place < cube.high + Real(1e-4)));
        }
    }
}

BOOST_AUTO_TEST_CASE(ball_that_rounding_left_beyond_a_plane_hits_it_at_once) {
    WalledCube<double> const cube(System{.side = 10});
    Ball<double> ball{};
    ball.point << 9.5 + 1e-15, 5, 5;
    ball.time = 3;
    ball.velocity << 1, 0, 0;
    BOOST_TEST(earliest_wall(ball, cube).time == 3);
    ball.velocity << -1, 0, 0;
    BOOST_TEST(earliest_wall(ball, cube).time > 11);
}

BOOST_AUTO_TEST_CASE(resting_ball_never_hits) {
    WalledCube<double> const cube(System{.side = 10});
    Ball<double> ball{};
    ball.point << 5, 5, 5;
    BOOST_TEST(earliest_wall(ball, cube).time == infinity<double>);
}

BOOST_AUTO_TEST_CASE(corner_goes_to_the_lower_wall_first) {
    WalledCube<double> const cube(System{.side = 10});
    Ball<double> ball{};
    ball.point << 5, 5, 5;
    ball.velocity << 1, 1, -1;
    BOOST_TEST(earliest_wall(ball, cube).wall == 1);
}

/// On a lattice of places and velocities edges, corners, planes and balls at rest are frequent.
BOOST_AUTO_TEST_CASE_TEMPLATE(three_directions_at_once_find_what_one_after_the_other_finds, Real,
                              Reals) {
    std::mt19937_64 random(2);
    WalledCube<Real> const cube(System{.side = 10});
    int found = 0;
    for (int k = 0; k < 20000; ++k) {
        Ball<Real> ball{};
        ball.point = made_up::in_cube<Real>(random, 0.4, 9.6);
        ball.velocity = made_up::in_cube<Real>(random, -2, 2);
        if (k % 2 == 0) {
            ball.point = (ball.point * Real(2)).array().round().matrix() / Real(2);
            ball.velocity = ball.velocity.array().round().matrix();
        }
        ball.time = static_cast<Real>(k % 3);
        auto const expected = earliest_wall_one_by_one(ball, cube), hit = earliest_wall(ball, cube);
        BOOST_TEST_REQUIRE((hit.time == expected.time));
        BOOST_TEST_REQUIRE(hit.wall == expected.wall);
        found += hit.time < infinity<Real>;
    }
    BOOST_TEST((found > 15000 && found < 20000)); // some are at rest
}
