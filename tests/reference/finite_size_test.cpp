#include "reference/equation_of_state.hpp"
#include "reference/finite_size.hpp"
#include "reference/published_table.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace clack::reference;

BOOST_AUTO_TEST_CASE(energy_shell_factor_is_exact_for_few_degrees_of_freedom) {
    // D = 1: |v| is fixed, its mean sqrt(kT/m); at fixed temperature it is sqrt(2 kT / (pi m)).
    BOOST_TEST(std::abs(energy_shell_factor(1) - std::sqrt(std::numbers::pi / 2)) < 1e-15);
    // D = 2: sqrt(1) Gamma(1) / Gamma(3/2) = 2 / sqrt(pi).
    BOOST_TEST(std::abs(energy_shell_factor(2) - 2 * std::numbers::inv_sqrtpi) < 1e-15);
    // D = 6: sqrt(3) Gamma(3) / Gamma(7/2) = sqrt(3) 2 / (15/8 sqrt(pi)).
    BOOST_TEST(std::abs(energy_shell_factor(6) -
                        16 * std::sqrt(3.0) / 15 * std::numbers::inv_sqrtpi) < 1e-15);
}

BOOST_AUTO_TEST_CASE(energy_shell_factor_goes_to_one_as_a_quarter_over_d) {
    for (double const d : {1e2, 1e4, 3e6})
        BOOST_TEST(std::abs(energy_shell_factor(d) - 1 - 1 / (4 * d)) < 1 / (16 * d * d));
    BOOST_CHECK_THROW(energy_shell_factor(0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(many_balls_have_the_infinite_fluids_compressibility) {
    double const rho = 0.5;
    double const z = modified_klm(rho * std::numbers::pi / 6);
    BOOST_TEST(std::abs(periodic_compressibility(rho, 1'000'000'000) - z) < 1e-8);
    // the finite-size term falls as 1/N
    double const short_of_100 = z - 1 - collisional_compressibility(rho, 100);
    double const short_of_200 = z - 1 - collisional_compressibility(rho, 200);
    BOOST_TEST(std::abs(short_of_100 / short_of_200 - 2) < 1e-9);
    BOOST_TEST(short_of_100 > 0.009); // rho P'' / (2 N P') = 0.0102
    BOOST_CHECK_THROW(collisional_compressibility(rho, 1), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(total_momentum_carries_no_pressure) {
    // No collisions: N balls without momentum press as N - 1.
    for (int const count : {2, 10, 1000})
        BOOST_TEST(std::abs(periodic_compressibility(0, count) - (1 - 1.0 / count)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(dilute_pair_correction_is_that_of_the_second_virial_coefficient) {
    // To first order Zc = B2 rho (N-1)/N: each ball meets N-1 others, not N.
    double const rho = 1e-5, b2 = 2 * std::numbers::pi / 3;
    for (int const count : {2, 10, 1000}) {
        double const expected = b2 * rho * (count - 1) / count;
        BOOST_TEST(std::abs(collisional_compressibility(rho, count) / expected - 1) < 1e-4);
    }
}

BOOST_AUTO_TEST_CASE(law_agrees_with_runs_of_another_code) {
    auto const table = PublishedTable::of_reference("periodic_md.csv");
    int judged = 0;
    for (std::size_t i = 0; i < table.row_count(); ++i) {
        double const rho = table.column("number_density")[i];
        auto const count = static_cast<std::int64_t>(table.column("count")[i]);
        bool const feels_its_images = (rho == 0.5 && count == 32) || (rho == 0.8 && count == 108);
        if (feels_its_images) continue;
        double const zc = collisional_compressibility(rho, count);
        double const rate = collision_rate(zc, 3 * static_cast<double>(count) - 3);
        BOOST_TEST_CONTEXT("number density " << rho << ", " << count << " balls") {
            // 3 standard errors: one of 12 numbers beyond by chance in 3 % of such tables
            BOOST_TEST(std::abs(zc - table.column("Zc")[i]) < 3 * table.column("Zc_error")[i]);
            BOOST_TEST(std::abs(rate - table.column("rate")[i]) <
                       3 * table.column("rate_error")[i]);
        }
        ++judged;
    }
    BOOST_TEST(judged == 6);
}

BOOST_AUTO_TEST_CASE(rate_and_compressibility_are_inverse) {
    for (double const zc : {0.01, 2.0, 11.0})
        BOOST_TEST(std::abs(collisional_from_rate(collision_rate(zc, 93), 93) / zc - 1) < 1e-15);
    // infinite fluid: 6 / sqrt(pi) = 3.385138 collisions a unit of Zc
    BOOST_TEST(std::abs(collision_rate(1, 1e9) - 3.385138) < 1e-6);
}
