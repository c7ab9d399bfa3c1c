#include "reference/walled_fluid.hpp"

#include "reference/equation_of_state.hpp"
#include "reference/published_table.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace clack::reference;

/// The second virial coefficient between walls: Z = 1 + (2 pi / 3) n (1 - 3 / (2 l)) with
/// n = N / l^3, up to the square of n and of 1 / l.
BOOST_AUTO_TEST_CASE(a_dilute_gas_between_walls_obeys_its_second_virial) {
    for (double const l : {50.0, 100.0}) {
        double const n = 1e-4;
        double const z = walled_compressibility(l + 1, n * l * l * l);
        double const exact = 1 + 2 * std::numbers::pi / 3 * n * (1 - 1.5 / l);
        BOOST_TEST(std::abs(z - exact) < 20 * n * n);
    }
}

/// Measured by clack, by the virial and by the walls alike, at 200 and 60 collisions per ball.
BOOST_AUTO_TEST_CASE(a_fluid_in_a_cube_of_twenty_diameters_is_met_to_a_hundredth) {
    BOOST_TEST(std::abs(walled_compressibility(20, 1000) - 1.3332) < 0.005);
    BOOST_TEST(std::abs(walled_compressibility(20, 4000) - 3.428) < 0.035);
}

BOOST_AUTO_TEST_CASE(a_large_cube_is_all_bulk) {
    double const side = 1e5, density = 0.6;
    BOOST_TEST(std::abs(walled_compressibility(side, density * std::pow(side, 3)) -
                        modified_klm(std::numbers::pi / 6 * density)) < 1e-3);
}

BOOST_AUTO_TEST_CASE(all_terms_together_are_what_another_code_measured) {
    auto const table = PublishedTable::of_reference("walled_cube_md.csv");
    BOOST_REQUIRE_EQUAL(table.row_count(), 5);
    for (std::size_t i = 0; i < table.row_count(); ++i) {
        WalledCubePressure const pressure =
            walled_cube_pressure(table.column("side")[i], table.column("count")[i]);
        double const measured = table.column("wall_pressure")[i];
        BOOST_TEST(std::abs(pressure.total() / measured - 1) < 1e-3);
        BOOST_TEST(std::abs(pressure.total() / table.column("expected")[i] - 1) < 1e-4);
        // without the walls' own terms it would be 2.5 % off and more
        BOOST_TEST(std::abs(pressure.bulk / measured - 1) > 0.025);
    }
}

BOOST_AUTO_TEST_CASE(dilute_gas_has_the_exact_terms_of_faces_and_edges) {
    // gamma = -(pi / 8) rho^2, tau = rho^2 / 15 to the lowest order
    double const l = 100, rho = 0.01;
    WalledCubePressure const pressure = walled_cube_pressure(l + 1, rho * l * l * l);
    double const square = pressure.bulk_density * pressure.bulk_density;
    BOOST_TEST(std::abs(pressure.faces / (std::numbers::pi / 2 * square / l) - 1) < 0.1);
    BOOST_TEST(std::abs(pressure.edges / (-4 * square / (15 * l * l)) - 1) < 0.15);
}

BOOST_AUTO_TEST_CASE(what_is_no_fluid_is_refused) {
    BOOST_CHECK_THROW(walled_cube_pressure(4, 20), std::invalid_argument);
    BOOST_CHECK_THROW(walled_cube_pressure(10, 1000), std::invalid_argument);
    BOOST_CHECK_THROW(walled_compressibility(4, 20), std::invalid_argument);
    BOOST_CHECK_THROW(walled_compressibility(10, 1), std::invalid_argument);
    BOOST_CHECK_THROW(walled_compressibility(10, 1000), std::invalid_argument);
}
