#include "reference/published_table.hpp"
#include "reference/two_balls.hpp"

#include <boost/test/unit_test.hpp>
#include <gsl/gsl_rng.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace clack::reference;

BOOST_AUTO_TEST_CASE(nearness_is_what_random_points_show) {
    gsl_rng* const random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, 20150714);
    constexpr int pairs = 200'000;
    int near_half = 0, near_one = 0;
    for (int k = 0; k < pairs; ++k) {
        double square = 0;
        for (int axis = 0; axis < 3; ++axis) {
            double const apart = gsl_rng_uniform(random) - gsl_rng_uniform(random);
            square += apart * apart;
        }
        near_half += square < 0.25;
        near_one += square < 1;
    }
    gsl_rng_free(random);
    // 4 standard errors of a count
    for (auto const& [x, count] : {std::pair{0.5, near_half}, {1.0, near_one}}) {
        double const p = nearer_probability(x);
        BOOST_TEST(std::abs(count - pairs * p) < 4 * std::sqrt(pairs * p * (1 - p)));
    }
}

BOOST_AUTO_TEST_CASE(density_is_the_derivative_of_the_probability) {
    for (double const x : {0.1, 0.5, 0.9}) {
        double const h = 1e-5;
        double const slope = (nearer_probability(x + h) - nearer_probability(x - h)) / (2 * h);
        BOOST_TEST(std::abs(slope / nearer_density(x) - 1) < 1e-8);
    }
}

BOOST_AUTO_TEST_CASE(wall_pressure_is_what_another_code_measured) {
    auto const table = PublishedTable::of_reference("two_balls_md.csv");
    BOOST_REQUIRE_EQUAL(table.row_count(), 2);
    for (std::size_t i = 0; i < table.row_count(); ++i) {
        TwoBalls const balls{.side = table.column("side")[i]};
        BOOST_TEST(std::abs(balls.wall_pressure() - table.column("wall_pressure")[i]) <
                   3 * table.column("wall_pressure_error")[i]);
    }
    BOOST_TEST(std::abs(TwoBalls{.side = 3}.wall_pressure() - 0.286112) < 0.51e-6);
    BOOST_TEST(std::abs(TwoBalls{.side = 2.2}.wall_pressure() - 1.941444) < 0.51e-6);
}

BOOST_AUTO_TEST_CASE(walls_and_collisions_share_the_virial) {
    // Virial theorem for the accessible side l about its middle: 3 l F = 2E + (collisions per time)
    // * <virial>, where <virial> = diameter * mass * <v_n^2> / <v_n> of the flux at contact.
    // At fixed energy <v_n^2> / <v_n> comes from n = 6: <v_n>_flux^... is computed here from the
    // density v (1 - m v^2 / (4E))^(3/2) of the normal relative speed at contact.
    TwoBalls const balls{.side = 3.4, .diameter = 1.1, .mass = 0.7, .kinetic_energy = 2.3};
    double const top = std::sqrt(4 * balls.kinetic_energy / balls.mass);
    double weight = 0, speed = 0;
    for (int k = 0; k < 200'000; ++k) {
        double const v = (k + 0.5) / 200'000 * top;
        double const density = v * std::pow(1 - v * v / (top * top), 1.5);
        weight += density;
        speed += density * v;
    }
    double const virial = balls.diameter * balls.mass * speed / weight;
    double const walls = 3 * balls.accessible_side() * balls.wall_force();
    BOOST_TEST(std::abs(walls / (2 * balls.kinetic_energy + balls.collision_rate() * virial) - 1) <
               1e-6);
}

BOOST_AUTO_TEST_CASE(tiny_balls_press_as_an_ideal_gas) {
    TwoBalls const balls{.side = 1, .diameter = 1e-9, .kinetic_energy = 3};
    BOOST_TEST(std::abs(balls.wall_pressure() - 2) < 1e-8); // N kT / V
    // dilute rate of one pair: pi d^2 <g> / V, <g> at fixed energy = sqrt(2) <v> c_6
    double const mean_relative =
        4 * std::numbers::inv_sqrtpi * 16 * std::sqrt(3.0) / 15 * std::numbers::inv_sqrtpi;
    BOOST_TEST(std::abs(balls.collision_rate() / (std::numbers::pi * 1e-18 * mean_relative) - 1) <
               1e-8);
}

BOOST_AUTO_TEST_CASE(cube_too_small_for_the_formula_is_refused) {
    BOOST_CHECK_THROW(TwoBalls{.side = 1.9}.wall_force(), std::invalid_argument);
    BOOST_CHECK_THROW(nearer_probability(1.01), std::invalid_argument);
}
