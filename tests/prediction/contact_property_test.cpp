#include "prediction/earliest.hpp"
#include "tests/made_up_balls.hpp"

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

using namespace clack;
using made_up::uniform;
using Reals = boost::mpl::list<float, double, long double>;
using LaneReals = boost::mpl::list<float, double>;

namespace {

/// Two records whose pair is at a random distance, from contact to far, on a course that comes
/// within `nearest` of the other's centre.
template <class Real> struct Encounter {
    Ball<Real> i, j;
    double scale;

    Encounter(std::mt19937_64& random, double nearest, double scale_) : scale(scale_) {
        Vector3<double> const direction = made_up::in_cube(random, -1, 1).normalized();
        Vector3<double> sideways = made_up::in_cube(random, -1, 1);
        sideways = (sideways - direction * direction.dot(sideways)).normalized();
        double const away = std::sqrt(std::max(0.0, 1 - nearest * nearest)) +
                            std::pow(10.0, uniform(random, -6, 2));
        double const speed = std::pow(10.0, uniform(random, -3, 3));
        Vector3<double> const drift = made_up::in_cube(random, -1, 1) * speed;
        Vector3<double> const r = (direction * away + sideways * nearest) * scale;
        i.point = made_up::in_cube<Real>(random, -scale, scale);
        j.point = i.point + r.cast<Real>();
        i.velocity = drift.cast<Real>();
        j.velocity = (drift - direction * speed).template cast<Real>();
        i.time = j.time = static_cast<Real>(uniform(random));
    }
};

template <class Real> quad distance_at(Encounter<Real> const& pair, Real time) {
    auto const at = [&](Ball<Real> const& ball) -> Vector3<quad> {
        return ball.point.template cast<quad>() +
               ball.velocity.template cast<quad>() * (quad(time) - quad(ball.time));
    };
    Vector3<quad> const apart = at(pair.j) - at(pair.i);
    return sqrt(dot<quad>(apart, apart));
}

template <class Real> Real touches_at(Ball<Real> const& i, Ball<Real> const& j, double diameter) {
    WalledCube<Real> const cube{System{.side = 1e9}};
    return SteadyDiameter<Real>(static_cast<Real>(diameter))
        .contact_time(pair_of(i, j, cube, later(i.time, j.time)));
}

template <class Real> bool same_bits(Real a, Real b) { return a == b || (a != a && b != b); }

} // namespace

/// The error of a contact is that of the time it is rounded to and of the coordinates: both are
/// counted, times 32.
BOOST_AUTO_TEST_CASE_TEMPLATE(balls_are_a_diameter_apart_when_they_touch, Real, Reals) {
    std::mt19937_64 random(1);
    for (int k = 0; k < 20000; ++k) {
        double const scale = std::pow(2.0, std::floor(uniform(random, -20, 20)));
        Encounter<Real> const pair(random, uniform(random, 0, 0.999), scale);
        Real const time = touches_at(pair.i, pair.j, scale);
        BOOST_TEST_REQUIRE((time >= pair.i.time));
        Vector3<Real> const v = pair.j.velocity - pair.i.velocity;
        quad const way = sqrt(quad(dot<Real>(v, v))) * quad(time);
        quad const flight = quad(pair.i.velocity.norm() + pair.j.velocity.norm()) * quad(time);
        quad const room = quad(scale) * 200;
        BOOST_TEST_REQUIRE((abs(distance_at(pair, time) - scale) <
                            32 * quad(unit_roundoff<Real>) * (way + flight + room)));
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(pairs_that_pass_by_or_recede_never_touch, Real, Reals) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 20000; ++k) {
        Encounter<Real> pair(random, uniform(random, 1.01, 3), 1);
        BOOST_TEST_REQUIRE(std::isnan(static_cast<double>(touches_at(pair.i, pair.j, 1))));
        Encounter<Real> parting(random, uniform(random), 1);
        std::swap(parting.i.velocity, parting.j.velocity);
        BOOST_TEST_REQUIRE(std::isnan(static_cast<double>(touches_at(parting.i, parting.j, 1))));
    }
}

/// Near grazing the answer may go either way within rounding, but a contact that is reported is
/// one.
BOOST_AUTO_TEST_CASE_TEMPLATE(grazing_contacts_are_true_to_rounding, Real, Reals) {
    std::mt19937_64 random(3);
    int touched = 0;
    for (int k = 0; k < 20000; ++k) {
        double const miss = std::pow(10.0, uniform(random, -17, -2)) * (k % 2 == 0 ? 1 : -1);
        Encounter<Real> const pair(random, 1 + miss, 1);
        Real const time = touches_at(pair.i, pair.j, 1);
        if (!(time == time)) {
            // the impact parameter is known to the rounding of a separation of up to 100 diameters
            BOOST_TEST_REQUIRE(miss >
                               -1000 * 100 * static_cast<double>(unit_roundoff<Real>) - 1e-14);
            continue;
        }
        ++touched;
        quad const flight = quad(pair.i.velocity.norm() + pair.j.velocity.norm()) * quad(time);
        quad const bound = 64 * quad(unit_roundoff<Real>) * (flight + 200);
        BOOST_TEST_REQUIRE((abs(distance_at(pair, time) - 1) < bound));
    }
    BOOST_TEST(touched > 5000);
}

/// From contact to a hundred diameters, at rest and on its way: nothing but the root can err. What
/// it errs by grows with the separation and no faster.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_root_is_as_true_as_its_separation, Real, Reals) {
    std::mt19937_64 random(9);
    int touched = 0;
    for (int k = 0; k < 20000; ++k) {
        Encounter<Real> pair(random, 1 - std::pow(10.0, uniform(random, -16, 0)), 1);
        pair.j.point -= pair.i.point;
        pair.j.velocity -= pair.i.velocity;
        pair.i.point.setZero();
        pair.i.velocity.setZero();
        pair.i.time = pair.j.time = 0;
        Real const time = touches_at(pair.i, pair.j, 1);
        if (!(time > 0)) continue;
        ++touched;
        quad const bound = 16 * quad(unit_roundoff<Real>) * quad(pair.j.point.norm());
        BOOST_TEST_REQUIRE((abs(distance_at(pair, time) - 1) < bound));
    }
    BOOST_TEST(touched > 10000);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(overlapping_pair_touches_now_if_it_approaches, Real, Reals) {
    std::mt19937_64 random(4);
    for (int k = 0; k < 5000; ++k) {
        Ball<Real> i{}, j{};
        i.velocity = made_up::in_cube<Real>(random, -1, 1);
        j.velocity = made_up::in_cube<Real>(random, -1, 1);
        j.point = made_up::in_cube<Real>(random, -0.5, 0.5);
        j.time = 0;
        i.time = 0;
        Real const time = touches_at(i, j, 1);
        bool const approaches = dot<Real>(j.point, j.velocity - i.velocity) < 0;
        BOOST_TEST_REQUIRE((approaches ? time == 0 : time != time));
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_pair_has_one_time_whichever_ball_asks, Real, Reals) {
    std::mt19937_64 random(5);
    PeriodicCube<Real> const cube{System{.boundary = Boundary::periodic, .side = 7.3}};
    SteadyDiameter<Real> const model(1);
    int touched = 0;
    for (int k = 0; k < 20000; ++k) {
        Ball<Real> ball[2];
        for (auto& each : ball) {
            each.point = made_up::in_cube<Real>(random, 0, 7.3);
            each.velocity = made_up::in_cube<Real>(random, -2, 2);
            each.time = static_cast<Real>(uniform(random));
        }
        Real const now = static_cast<Real>(uniform(random, 1, 2));
        Real const ij = model.contact_time(pair_of(ball[0], ball[1], cube, now));
        Real const ji = model.contact_time(pair_of(ball[1], ball[0], cube, now));
        touched += ij == ij;
        BOOST_TEST_REQUIRE(same_bits(ij, ji));
    }
    BOOST_TEST(touched > 100);
}

/// The moment that a prediction is made at picks the image and has no other say.
BOOST_AUTO_TEST_CASE(a_time_does_not_depend_on_when_it_is_asked_for) {
    std::mt19937_64 random(6);
    PeriodicCube<double> const cube{System{.boundary = Boundary::periodic, .side = 9.7}};
    SteadyDiameter<double> const model(1);
    int touched = 0;
    for (int k = 0; k < 20000; ++k) {
        Ball<double> i{}, j{};
        i.point = made_up::in_cube(random, 0, 9.7);
        j.point = i.point + made_up::in_cube(random, -2, 2);
        cube.wrap(j.point);
        i.velocity = made_up::in_cube(random, -1, 1);
        j.velocity = made_up::in_cube(random, -1, 1);
        i.time = uniform(random, 0, 0.1);
        j.time = uniform(random, 0, 0.1);
        double const early = model.contact_time(pair_of(i, j, cube, 0.1));
        double const late = model.contact_time(pair_of(i, j, cube, 0.3));
        touched += early > 0.3;
        BOOST_TEST_REQUIRE(same_bits(early, late));
    }
    BOOST_TEST(touched > 1000);
}

namespace {

/// A crowd of records of different ages, one of which is asked for its earliest contact.
template <class Real, class Container> void compare_lanes_with_one_by_one(Boundary boundary) {
    std::mt19937_64 random(7);
    System const system{.boundary = boundary, .side = 11, .count = 64};
    Container const cube(system);
    SteadyDiameter<Real> const model(1);
    std::vector<Ball<Real>> balls(64);
    std::vector<std::int32_t> numbers(64);
    int touched = 0;
    for (int round = 0; round < 3000; ++round) {
        for (std::size_t k = 0; k < 64; ++k) {
            balls[k].point = made_up::in_cube<Real>(random, 0.5, 10.5);
            balls[k].velocity = made_up::in_cube<Real>(random, -2, 2);
            balls[k].time = static_cast<Real>(uniform(random, 0, 0.5));
            numbers[k] = static_cast<std::int32_t>(63 - k);
        }
        // A ball that was just written, ties, and padding
        if (round % 2 == 0) balls[0].time = Real(0.5);
        if (round % 3 == 0) balls[9] = balls[17];
        std::vector<std::int32_t> candidates;
        for (std::int32_t k = 1; k < 1 + round % 60; ++k) candidates.push_back(k);
        while (candidates.size() % lane_count != 0) candidates.push_back(0);
        Scenery<Real, Container, SteadyDiameter<Real>> const scenery{balls, numbers, cube, model,
                                                                     false};
        auto const eight = earliest_contact(scenery, 0, candidates, Real(0.5));
        auto const single = earliest_one_by_one(scenery, 0, candidates, Real(0.5));
        BOOST_TEST_REQUIRE(eight.ball == single.ball);
        BOOST_TEST_REQUIRE((eight.time == single.time));
        touched += single.ball != no_ball;
    }
    BOOST_TEST(touched > 500);
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(eight_at_a_time_give_the_bits_of_one_by_one, Real, LaneReals) {
    compare_lanes_with_one_by_one<Real, WalledCube<Real>>(Boundary::walls);
    compare_lanes_with_one_by_one<Real, PeriodicCube<Real>>(Boundary::periodic);
}
