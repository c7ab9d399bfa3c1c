#include "scenes/velocities.hpp"

#include "tests/scenes/places.hpp"

#include <boost/test/unit_test.hpp>

using namespace clack;
using namespace clack::test;

namespace {

using Draw = Eigen::Matrix3Xd (*)(System const&, double, std::uint64_t);

constexpr double epsilon = std::numeric_limits<double>::epsilon();

System system_of(Boundary boundary, std::int64_t count) { return {boundary, 20, count, 1, 2.5}; }

template <class Check> void for_each_case(Check check) {
    for (Draw const draw : {Draw(draw_maxwell_velocities), Draw(draw_equal_speeds)})
        for (auto const boundary : {Boundary::walls, Boundary::periodic})
            for (std::int64_t const count : {1, 2, 3, 5, 100, 5000})
                check(system_of(boundary, count), draw);
}

} // namespace

BOOST_AUTO_TEST_CASE(temperature_is_exact_to_rounding) {
    for_each_case([](System const& system, Draw draw) {
        auto const velocities = draw(system, 0.7, 11);
        long double squares = 0;
        for (double const v : velocities.reshaped()) squares += static_cast<long double>(v) * v;
        auto const kT = static_cast<double>(system.mass * squares / system.degrees_of_freedom());
        // Four roundings of the factor count twice in the square; those of the terms average out.
        BOOST_TEST(std::abs(kT / 0.7 - 1) <= 8 * epsilon);
    });
}

BOOST_AUTO_TEST_CASE(periodic_momentum_is_zero_to_rounding) {
    for_each_case([](System const& system, Draw draw) {
        if (system.boundary == Boundary::walls || system.count == 1) return;
        auto const velocities = draw(system, 0.7, 12);
        for (int axis = 0; axis < 3; ++axis) {
            long double momentum = 0;
            for (double const v : velocities.row(axis)) momentum += v;
            // One rounding of half an ulp of a speed below 4 a ball, and as many signs.
            double const count = static_cast<double>(system.count);
            BOOST_TEST(std::abs(static_cast<double>(momentum)) <= 8 * epsilon * std::sqrt(count));
        }
    });
}

BOOST_AUTO_TEST_CASE(a_single_ball_keeps_its_velocity) {
    for (auto const boundary : {Boundary::walls, Boundary::periodic}) {
        System const system = system_of(boundary, 1);
        auto const velocity = draw_maxwell_velocities(system, 2, 3);
        double const x = velocity(0, 0), y = velocity(1, 0), z = velocity(2, 0);
        BOOST_TEST(system.mass * (x * x + y * y + z * z) == 3 * 2.0,
                   boost::test_tools::tolerance(4 * epsilon));
    }
}

BOOST_AUTO_TEST_CASE(equal_speeds_are_equal_between_walls) {
    System const system = system_of(Boundary::walls, 1000);
    auto const velocities = draw_equal_speeds(system, 1, 4);
    double const speed = std::sqrt(3 / system.mass);
    for (auto const& velocity : velocities.colwise())
        BOOST_TEST(std::abs(velocity.norm() - speed) <= 4 * epsilon);
}

BOOST_AUTO_TEST_CASE(directions_favour_no_axis) {
    System const system = system_of(Boundary::walls, 20000);
    auto const velocities = draw_equal_speeds(system, 1, 5);
    double const square = 3 / system.mass; // of the speed
    for (int axis = 0; axis < 3; ++axis) {
        auto const component = velocities.row(axis).array() / std::sqrt(square);
        // Uniform in [-1, 1]: moments 0, 1/3, 1/5 with variances 1/3, 4/45, 16/225 over n; 4
        // errors.
        BOOST_TEST(std::abs(component.mean()) < 4 * std::sqrt(1 / 3.0 / 20000));
        BOOST_TEST(std::abs(component.square().mean() - 1 / 3.0) < 4 * std::sqrt(4 / 45.0 / 20000));
        BOOST_TEST(std::abs(component.pow(4).mean() - 0.2) < 4 * std::sqrt(16 / 225.0 / 20000));
    }
}

BOOST_AUTO_TEST_CASE(maxwell_components_have_normal_moments) {
    System const system = system_of(Boundary::walls, 20000);
    auto const velocities = draw_maxwell_velocities(system, system.mass, 6);
    for (int axis = 0; axis < 3; ++axis) {
        auto const component = velocities.row(axis).array();
        // Variances 1, 2, 96 over n; 4 errors.
        BOOST_TEST(std::abs(component.mean()) < 4 * std::sqrt(1 / 20000.0));
        BOOST_TEST(std::abs(component.square().mean() - 1) < 4 * std::sqrt(2 / 20000.0));
        BOOST_TEST(std::abs(component.pow(4).mean() - 3) < 4 * std::sqrt(96 / 20000.0));
    }
}

BOOST_AUTO_TEST_CASE(temperature_zero_is_rest) {
    BOOST_TEST(draw_maxwell_velocities(system_of(Boundary::periodic, 5), 0, 1).isZero(0));
    BOOST_TEST(draw_equal_speeds(system_of(Boundary::walls, 5), 0, 1).isZero(0));
}

BOOST_AUTO_TEST_CASE(velocities_have_these_bits_on_every_machine) {
    BOOST_TEST(hash_of(draw_maxwell_velocities(system_of(Boundary::periodic, 1000), 1, 7)) ==
               2897908085069796928u);
    BOOST_TEST(hash_of(draw_equal_speeds(system_of(Boundary::walls, 1000), 1, 7)) ==
               12303177268286108314u);
}
