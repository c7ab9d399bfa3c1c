// Hard balls whose diameter yields, against soft ones integrated here and against the law itself.

#include "validation/softened_balls.hpp"

#include "prediction/earliest.hpp"
#include "tests/made_up_balls.hpp"
#include "validation/soft_runs.hpp"

#include <boost/test/unit_test.hpp>

using namespace clack;
using namespace clack::validation;
using made_up::uniform;

namespace {

System const wide{.side = 1e3, .count = 2};
WalledCube<double> const cube(wide);

/// Two balls on a course that comes within `nearest` of the other's centre, at least 1.2 apart.
std::array<Ball<double>, 2> encounter(std::mt19937_64& random, double nearest) {
    Vector3<double> const direction = made_up::in_cube(random, -1, 1).normalized();
    Vector3<double> sideways = made_up::in_cube(random, -1, 1);
    sideways = (sideways - direction * direction.dot(sideways)).normalized();
    double const speed = std::pow(10.0, uniform(random, -2, 1));
    Vector3<double> const drift = made_up::in_cube(random, -1, 1);
    std::array<Ball<double>, 2> balls;
    balls[0].point = Vector3<double>::Constant(500);
    balls[1].point = balls[0].point + direction * uniform(random, 1.2, 4) + sideways * nearest;
    balls[0].velocity = drift;
    balls[1].velocity = drift - direction * speed;
    return balls;
}

/// Where the pair is at a later time of the same flight.
Pair<double> moved(Pair<double> pair, double time) {
    double const wait = time - pair.time;
    pair.x += pair.vx * wait;
    pair.y += pair.vy * wait;
    pair.z += pair.vz * wait;
    pair.time = time;
    return pair;
}

/// Two soft balls from a segment's start to its end, in small steps.
Eigen::Matrix3Xd soft_end(Segment const& segment, double k, int steps_per_contact) {
    double const duration = reference::contact_duration(k);
    auto const steps = static_cast<int>(std::ceil(segment.time / duration * steps_per_contact));
    double const dt = segment.time / steps;
    Eigen::Matrix3Xd x = segment.start.positions, v = segment.start.velocities;
    auto const push = [&]() -> Eigen::Vector3d { // on ball 1
        Eigen::Vector3d const apart = x.col(1) - x.col(0);
        double const distance = apart.norm();
        return distance < 1 ? Eigen::Vector3d(k * (1 - distance) / distance * apart)
                            : Eigen::Vector3d::Zero();
    };
    for (int step = 0; step < steps; ++step) {
        v.col(1) += dt / 2 * push();
        v.col(0) -= dt / 2 * push();
        x += dt * v;
        v.col(1) += dt / 2 * push();
        v.col(0) -= dt / 2 * push();
    }
    return x;
}

/// How far soft balls end from yielding and from unyielding hard ones, when they pass at a
/// distance.
struct Errors {
    double yielding, plain;
};

Errors errors_of(double nearest, double k) {
    System const system{.side = 20, .count = 2};
    Start start{Eigen::Matrix3Xd(3, 2), Eigen::Matrix3Xd(3, 2)};
    start.positions.col(0) = Eigen::Vector3d(9, 9, 9);
    start.positions.col(1) =
        Eigen::Vector3d(9.1 + std::sqrt(1 - nearest * nearest), 9 + nearest, 9);
    start.velocities.col(0) = Eigen::Vector3d(1, 0.1, 0);
    start.velocities.col(1) = Eigen::Vector3d(-1, 0, 0.2);
    auto const engine = true_segment_engine(system, start);
    Segment const hard = fly(*engine, 0.2);
    BOOST_TEST_REQUIRE(hard.meetings.size() == 1);
    int const steps = 1600; // where in a step a contact begins no longer matters
    Eigen::Matrix3Xd const soft = soft_end(hard, k, steps);
    Segment const yielding = softened<SoftenedBalls>(system, hard, k, steps);
    auto const distance = [&](Segment const& other) {
        return (soft - other.end.positions).colwise().norm().maxCoeff();
    };
    return {distance(yielding), distance(hard)};
}

} // namespace

BOOST_AUTO_TEST_CASE(contacts_are_where_the_normal_speed_puts_them) {
    std::mt19937_64 random(1);
    double const duration = 2e-2;
    SoftenedBalls<double> const model(wide, duration);
    for (int k = 0; k < 20000; ++k) {
        auto const balls = encounter(random, uniform(random, 0, 0.9999));
        Pair<double> const pair = pair_of(balls[0], balls[1], cube, 0.0);
        double const time = model.contact_time(pair);
        BOOST_TEST_REQUIRE((time > 0));
        Pair<double> const there = moved(pair, time);
        Vector3<double> const r{there.x, there.y, there.z}, v{there.vx, there.vy, there.vz};
        double const reach = 1 + r.dot(v) / r.norm() * duration / 2; // r.v < 0
        BOOST_TEST_REQUIRE(std::abs(r.norm() - reach) < 1e-13);
        BOOST_TEST_REQUIRE(std::abs(model.diameter_squared(there, time) - r.dot(r)) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(grazing_contacts_are_found_and_misses_are_not) {
    std::mt19937_64 random(2);
    SoftenedBalls<double> const model(wide, 2e-2);
    for (int k = 0; k < 20000; ++k) {
        double const miss = std::pow(10.0, uniform(random, -12, -2));
        auto const hits = encounter(random, 1 - miss), passes = encounter(random, 1 + miss);
        Pair<double> const pair = pair_of(hits[0], hits[1], cube, 0.0);
        double const time = model.contact_time(pair);
        BOOST_TEST_REQUIRE((time > 0));
        Pair<double> const there = moved(pair, time);
        double const distance2 = there.x * there.x + there.y * there.y + there.z * there.z;
        BOOST_TEST_REQUIRE(std::abs(distance2 - model.diameter_squared(there, time)) < 1e-11);
        BOOST_TEST_REQUIRE(
            std::isnan(model.contact_time(pair_of(passes[0], passes[1], cube, 0.0))));
    }
}

BOOST_AUTO_TEST_CASE(without_duration_they_are_elastic_balls) {
    std::mt19937_64 random(3);
    SoftenedBalls<double> const model(wide, 0);
    ElasticBalls<double> const elastic(wide);
    for (int k = 0; k < 5000; ++k) {
        auto const balls = encounter(random, uniform(random, 0, 0.999));
        Pair<double> const pair = pair_of(balls[0], balls[1], cube, 0.0);
        double const expected = elastic.contact_time(pair);
        BOOST_TEST_REQUIRE(std::abs(model.contact_time(pair) - expected) < 1e-11 * expected);
    }
}

BOOST_AUTO_TEST_CASE(eight_at_a_time_give_the_same_bits) {
    std::mt19937_64 random(4);
    SoftenedBalls<double> const model(wide, 2e-2);
    for (int k = 0; k < 2000; ++k) {
        Pair<Lanes<double>> eight{};
        double one_by_one[lane_count];
        for (int lane = 0; lane < lane_count; ++lane) {
            auto const balls = encounter(random, uniform(random, 0, 1.3));
            Pair<double> const p = pair_of(balls[0], balls[1], cube, 0.0);
            one_by_one[lane] = model.contact_time(p);
            eight.x[lane] = p.x, eight.y[lane] = p.y, eight.z[lane] = p.z;
            eight.vx[lane] = p.vx, eight.vy[lane] = p.vy, eight.vz[lane] = p.vz;
            eight.time[lane] = p.time;
        }
        Lanes<double> const times = model.contact_time(eight);
        for (int lane = 0; lane < lane_count; ++lane)
            BOOST_TEST_REQUIRE((times[lane] == one_by_one[lane] ||
                                (std::isnan(times[lane]) && std::isnan(one_by_one[lane]))));
    }
}

BOOST_AUTO_TEST_CASE(walls_turn_balls_round_half_a_contact_later) {
    SoftenedBalls<double> const model(wide, 2e-2);
    Ball<double> ball;
    ball.point = Vector3<double>(998, 500, 500);
    ball.velocity = Vector3<double>(3, 1, 0);
    WallContact<double> const contact = model.wall_contact(ball, cube);
    BOOST_TEST(contact.wall == 1);
    BOOST_TEST(std::abs(contact.time - (0.5 + 1e-2)) < 1e-12);
    double const plane = model.plane(cube, 1, contact.time, ball.velocity[0]);
    BOOST_TEST(std::abs(plane - ball.position(contact.time)[0]) < 1e-12);
    BOOST_TEST(std::abs(model.plane(cube, -1, 0, -3.0) - (0.5 - 3e-2)) < 1e-12);
}

/// Of first order without the yielding diameter, of second order with it, head-on next to nothing.
BOOST_AUTO_TEST_CASE(soft_balls_end_where_yielding_ones_do) {
    for (double const nearest : {0.3, 0.6, 0.8}) {
        Errors const soft = errors_of(nearest, 2e5), hard = errors_of(nearest, 16 * 2e5);
        BOOST_TEST_MESSAGE(soft.plain << ' ' << hard.plain << ' ' << soft.yielding << ' '
                                      << hard.yielding);
        BOOST_TEST(std::abs(soft.plain / hard.plain - 4) < 0.1);
        BOOST_TEST(std::abs(soft.yielding / hard.yielding - 16) < 4);
        BOOST_TEST(soft.yielding < 1e-2 * soft.plain);
    }
}
