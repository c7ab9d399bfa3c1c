#include "scenes/packing.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace clack;

BOOST_AUTO_TEST_CASE(cube_root_is_right_to_an_ulp) {
    for (double const root : {1.0, 2.0, 3.0, 10.0, 0.5, 1e-20, 1e20, 1.5, 0.7, 1.26, 1.59})
        for (double const value : {root * root * root, root, std::nextafter(root, 2.0)}) {
            double const expected = static_cast<double>(std::cbrt(static_cast<long double>(value)));
            double const ulp = std::nextafter(expected, 2 * expected) - expected;
            BOOST_TEST(std::abs(cube_root(value) - expected) <= ulp);
        }
    BOOST_TEST(cube_root(8) == 2);
    BOOST_TEST(cube_root(1000) == 10);
    BOOST_TEST(cube_root(0x1p-300) == 0x1p-100);
}

BOOST_AUTO_TEST_CASE(side_has_these_bits_on_every_machine) {
    BOOST_TEST(side_of_packing_fraction(1000, 1, 0.49) == 10.223529333914984);
    BOOST_TEST(side_of_packing_fraction(4096, 0.3, 0.001) == 38.687806896395266);
    BOOST_TEST(side_of_packing_fraction(7, 1.7, 0.6) == 3.1076401611693885);
}

BOOST_AUTO_TEST_CASE(lattices_are_the_smallest_that_hold_the_balls) {
    BOOST_TEST(grid_sites_per_side(1) == 1);
    BOOST_TEST(grid_sites_per_side(2) == 2);
    BOOST_TEST(grid_sites_per_side(8) == 2);
    BOOST_TEST(grid_sites_per_side(9) == 3);
    BOOST_TEST(grid_sites_per_side(1000000) == 100);
    BOOST_TEST(grid_sites_per_side(1000001) == 101);
    BOOST_TEST(fcc_layers_per_side(Boundary::periodic, 4) == 2);
    BOOST_TEST(fcc_layers_per_side(Boundary::periodic, 5) == 4);
    BOOST_TEST(fcc_layers_per_side(Boundary::periodic, 32) == 4);
    BOOST_TEST(fcc_layers_per_side(Boundary::walls, 1) == 1);
    BOOST_TEST(fcc_layers_per_side(Boundary::walls, 4) == 2);
    BOOST_TEST(fcc_layers_per_side(Boundary::walls, 14) == 3);
    BOOST_TEST(fcc_layers_per_side(Boundary::walls, 15) == 4);
    for (std::int64_t count : {1, 2, 3, 5, 13, 14, 15, 62, 63, 100, 4096, 134217727})
        for (auto const boundary : {Boundary::walls, Boundary::periodic}) {
            auto const layers = fcc_layers_per_side(boundary, count);
            auto const step = boundary == Boundary::periodic ? 2 : 1;
            BOOST_TEST(fcc_site_count(layers) >= count);
            BOOST_TEST((layers == step || fcc_site_count(layers - step) < count));
        }
}

BOOST_AUTO_TEST_CASE(a_full_fcc_lattice_reaches_close_packing) {
    for (std::int64_t const cells : {1, 2, 5, 10})
        BOOST_TEST(largest_packing_fraction(Arrangement::fcc, Boundary::periodic,
                                            4 * cells * cells * cells) == close_packing,
                   boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(what_is_said_to_fit_fits) {
    for (auto const arrangement : {Arrangement::grid, Arrangement::fcc, Arrangement::random})
        for (auto const boundary : {Boundary::walls, Boundary::periodic})
            for (std::int64_t const count : {1, 2, 3, 5, 14, 100, 1000}) {
                double const largest = largest_packing_fraction(arrangement, boundary, count);
                auto const reason = [&](double packing_fraction) {
                    System const system{boundary,
                                        side_of_packing_fraction(count, 1, packing_fraction), count,
                                        1, 1};
                    return why_it_does_not_fit(system, arrangement, CubeGivenBy::packing_fraction);
                };
                BOOST_TEST(reason(largest) == "");
                BOOST_TEST(reason(largest * 1.0001) != "");
            }
}
