#include "cli/standstill.hpp"
#include "state/errors.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

using namespace clack;

namespace {

System const pair{Boundary::periodic, 10, 2, 1, 1};
// Two balls of unit speed: energy 1, and one collision in V / (sqrt(2) pi 2) on average.
double const wait = 1000 / (std::numbers::sqrt2 * std::numbers::pi * 2);

} // namespace

BOOST_AUTO_TEST_CASE(a_million_waits_without_a_collision_are_enough) {
    StandstillWatch watch(pair, 1, "here.toml");
    BOOST_CHECK_NO_THROW(watch.look(0.999e6 * wait, 0, 0));
    BOOST_CHECK_THROW(watch.look(1.001e6 * wait, 0, 0), InputError);
}

BOOST_AUTO_TEST_CASE(each_collision_begins_anew) {
    StandstillWatch watch(pair, 1, "here.toml");
    for (std::uint64_t k = 1; k < 10; ++k) {
        BOOST_CHECK_NO_THROW(watch.look(0.9e6 * wait * static_cast<double>(k), k, 200'000 * k));
    }
}

BOOST_AUTO_TEST_CASE(frames_of_nothing_shorten_it) {
    StandstillWatch watch(pair, 1, "here.toml");
    BOOST_CHECK_NO_THROW(watch.look(999 * wait, 0, 10'000'000));
    BOOST_CHECK_NO_THROW(watch.look(1001 * wait, 0, 100'000));
    BOOST_CHECK_THROW(watch.look(1001 * wait, 0, 100'001), InputError);
}

/// Ten million balls on a lattice fly a while before the first two meet.
BOOST_AUTO_TEST_CASE(many_balls_are_given_the_time_that_each_needs) {
    System const many{Boundary::periodic, 1000, 20'000'000, 1, 1};
    double const wait_of_any = wait / 1e8; // 1e7 times the balls, ten times as close
    StandstillWatch watch(many, 1e7, "here.toml");
    BOOST_CHECK_NO_THROW(watch.look(1e7 * wait_of_any, 0, 0));
    BOOST_CHECK_NO_THROW(watch.look(1e7 * wait_of_any, 0, 200'000));
    BOOST_CHECK_THROW(watch.look(1e11 * wait_of_any, 0, 0), InputError);
}
