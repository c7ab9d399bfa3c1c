#include "reference/crystal.hpp"
#include "reference/equation_of_state.hpp"
#include "reference/published_table.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace clack::reference;

namespace {

double packing_fraction(double const number_density) {
    return number_density * std::numbers::pi / 6;
}

} // namespace

BOOST_AUTO_TEST_CASE(fluid_has_the_tabulated_compressibility_and_pressure) {
    auto const table = PublishedTable::of_reference("eos_fluid_values.csv");
    BOOST_REQUIRE_EQUAL(table.row_count(), 27);
    for (std::size_t i = 0; i < table.row_count(); ++i) {
        double const rho = table.column("number_density")[i];
        Pressure const pressure = modified_klm_pressure(rho);
        BOOST_TEST_CONTEXT("number density " << rho) {
            // half a unit of the last digit that the table prints
            BOOST_TEST(std::abs(modified_klm(packing_fraction(rho)) - table.column("Z_mklm")[i]) <
                       0.51e-7);
            BOOST_TEST(std::abs(pressure.value - table.column("P_mklm")[i]) < 0.51e-7);
            // the table's derivatives are differences of the pressure
            BOOST_TEST(std::abs(pressure.slope / table.column("dP_mklm")[i] - 1) < 1e-7);
            BOOST_TEST(std::abs(pressure.curvature / table.column("d2P_mklm")[i] - 1) < 3e-6);
            BOOST_TEST(std::abs(carnahan_starling(packing_fraction(rho)) -
                                table.column("Z_cs")[i]) < 0.51e-7);
        }
    }
}

BOOST_AUTO_TEST_CASE(two_independent_fits_agree_within_the_stated_error) {
    auto const table = PublishedTable::of_reference("eos_fluid_values.csv");
    for (std::size_t i = 0; i < table.row_count(); ++i) {
        double const rho = table.column("number_density")[i];
        if (rho > 1.0) continue; // beyond the stated range
        double const schultz = schultz_fluid(packing_fraction(rho));
        BOOST_TEST(std::abs(schultz - table.column("Z_schultz")[i]) < 0.51e-7);
        BOOST_TEST(std::abs(modified_klm(packing_fraction(rho)) / schultz - 1) < 2e-5);
    }
}

BOOST_AUTO_TEST_CASE(dilute_fluid_has_the_exact_virial_coefficients) {
    double const b4 =
        (2707 * std::numbers::pi + 438 * std::numbers::sqrt2 - 4131 * std::acos(1.0 / 3)) /
        (70 * std::numbers::pi);
    for (double const eta : {1e-4, 1e-3}) {
        double const expansion = 1 + eta * (4 + eta * (10 + eta * b4));
        double const next = 28.22445 * std::pow(eta, 4);
        BOOST_TEST(std::abs(modified_klm(eta) - expansion - next) < 50 * std::pow(eta, 5) + 1e-15);
        BOOST_TEST(std::abs(carnahan_starling(eta) - 1 - 4 * eta - 10 * eta * eta) <
                   20 * std::pow(eta, 3));
    }
}

BOOST_AUTO_TEST_CASE(derivatives_are_those_of_the_pressure) {
    for (double const rho : {0.05, 0.3, 0.6, 0.9}) {
        double const h = 1e-4; // central differences: error h^2 P''' / 6, below 1e-5 here
        Pressure const low = modified_klm_pressure(rho - h), high = modified_klm_pressure(rho + h);
        Pressure const here = modified_klm_pressure(rho);
        BOOST_TEST(std::abs((high.value - low.value) / (2 * h) / here.slope - 1) < 1e-6);
        BOOST_TEST(std::abs((high.slope - low.slope) / (2 * h) / here.curvature - 1) < 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(crystal_has_the_tabulated_compressibility) {
    auto const table = PublishedTable::of_reference("eos_crystal_values.csv");
    BOOST_REQUIRE_EQUAL(table.row_count(), 13);
    for (std::size_t i = 0; i < table.row_count(); ++i) {
        double const rho = table.column("number_density")[i];
        double const eta = packing_fraction(rho);
        double const schultz = schultz_crystal(eta), speedy = speedy_crystal(eta);
        BOOST_TEST(std::abs(schultz - table.column("Z_schultz")[i]) < 0.51e-5);
        BOOST_TEST(std::abs(speedy - table.column("Z_speedy")[i]) < 0.51e-5);
        BOOST_TEST(std::abs(schultz / speedy - 1) < (rho < 1.04 ? 6e-4 : 3e-4));
        // 3 (N - 1) / N of the leading term
        double const y = 1 - rho / std::numbers::sqrt2;
        BOOST_TEST(std::abs(schultz - periodic_crystal(eta, 100) - 0.03 / y) < 1e-9);
    }
    BOOST_CHECK_THROW(schultz_crystal(close_packing_fraction()), std::invalid_argument);
    BOOST_CHECK_THROW(speedy_crystal(0.5), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(theory_is_refused_outside_its_range) {
    BOOST_CHECK_THROW(modified_klm(-0.01), std::invalid_argument);
    BOOST_CHECK_THROW(modified_klm(0.55), std::invalid_argument);
    BOOST_CHECK_THROW(modified_klm_pressure(1.1), std::invalid_argument);
    BOOST_CHECK_THROW(modified_klm(std::nan("")), std::invalid_argument);
    BOOST_CHECK_THROW(carnahan_starling(1), std::invalid_argument);
}
