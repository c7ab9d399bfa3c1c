// Places of lattices and random arrangements.

#include "scenes/insertion.hpp"
#include "scenes/lattice.hpp"
#include "scenes/near_places.hpp"
#include "scenes/packing.hpp"
#include "tests/scenes/places.hpp"

#include <boost/test/unit_test.hpp>

using namespace clack;
using namespace clack::test;

namespace {

std::vector<std::int64_t> const counts{1, 2, 3, 5, 14, 31, 100};

System system_of(Boundary boundary, std::int64_t count, double packing_fraction) {
    return {boundary, side_of_packing_fraction(count, 1.3, packing_fraction), count, 1.3, 1};
}

/// Balls that are looked at, a ball, when all are put into a cube so wide one by one.
double visits_a_ball(double side, Eigen::Matrix3Xd const& places) {
    NearPlaces near({Boundary::walls, side, places.cols(), 1, 1}, 1, places.cols());
    std::int64_t visits = 0;
    for (auto const& place : places.colwise()) {
        near.visit_near(place, [&](std::int32_t) { return ++visits, NearPlaces::Visit::go_on; });
        near.add(place);
    }
    return static_cast<double>(visits) / static_cast<double>(places.cols());
}

} // namespace

BOOST_AUTO_TEST_CASE(lattices_hold_no_overlap_up_to_their_limit) {
    for (auto const arrangement : {Arrangement::grid, Arrangement::fcc})
        for (auto const boundary : {Boundary::walls, Boundary::periodic})
            for (auto const count : counts)
                for (double const share : {0.01, 0.5, 1.0}) {
                    double const limit = largest_packing_fraction(arrangement, boundary, count);
                    System const system = system_of(boundary, count, share * limit);
                    auto const places = arrangement == Arrangement::grid ? place_on_grid(system)
                                                                         : place_on_fcc(system);
                    BOOST_TEST_CONTEXT(count << " balls, " << share << " of the limit")
                    check_places(system, places);
                }
}

BOOST_AUTO_TEST_CASE(the_limit_of_a_lattice_is_its_own) {
    for (auto const boundary : {Boundary::walls, Boundary::periodic})
        for (std::int64_t const count : {2, 3, 5, 14, 31, 100}) {
            double const limit = largest_packing_fraction(Arrangement::fcc, boundary, count);
            System const system = system_of(boundary, count, limit);
            // All sites of a full lattice touch; of one with gaps the layers still do.
            BOOST_TEST(fcc_layer_distance(system, fcc_layers_per_side(boundary, count)) *
                               std::sqrt(2.0) ==
                           system.diameter,
                       boost::test_tools::tolerance(1e-14));
        }
}

BOOST_AUTO_TEST_CASE(a_grid_is_filled_in_order_and_centred) {
    System const system{Boundary::walls, 6, 10, 1, 1};
    auto const places = place_on_grid(system);
    BOOST_TEST((places.col(0) == Eigen::Vector3d(1, 1, 1)));
    BOOST_TEST((places.col(1) == Eigen::Vector3d(3, 1, 1)));
    BOOST_TEST((places.col(3) == Eigen::Vector3d(1, 3, 1)));
    BOOST_TEST((places.col(9) == Eigen::Vector3d(1, 1, 3)));
}

BOOST_AUTO_TEST_CASE(empty_fcc_sites_are_spread_evenly) {
    System const system = system_of(Boundary::periodic, 100, 0.1); // 108 sites
    auto const places = place_on_fcc(system);
    // Every layer of 18 sites lacks one ball or two.
    for (int layer = 0; layer < 6; ++layer) {
        double const height = system.side / 2 + (layer - 2.5) * system.side / 6;
        auto const filled = ((places.row(2).array() - height).abs() < 1e-9).count();
        BOOST_TEST((filled == 16 || filled == 17));
    }
}

BOOST_AUTO_TEST_CASE(fcc_between_walls_leaves_a_gap_at_the_walls) {
    System const system{Boundary::walls, 10, 63, 1, 1}; // 5 layers
    auto const places = place_on_fcc(system);
    double const neighbours = (places.col(0) - places.col(1)).norm(); // along x: 2 layers
    double const gap = neighbours / std::sqrt(2.0) - 1;
    BOOST_TEST(lowest(places) - 0.5 == gap / 2, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(9.5 - highest(places) == gap / 2, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(random_places_hold_no_overlap) {
    for (auto const boundary : {Boundary::walls, Boundary::periodic})
        for (auto const count : counts)
            for (double const packing_fraction : {1e-6, 0.01, 0.1, 0.2}) {
                System const system = system_of(boundary, count, packing_fraction);
                if (system.accessible_side() < system.diameter) continue; // dense: grown
                BOOST_TEST_CONTEXT(count << " balls at " << packing_fraction)
                check_places(system, place_at_random(system, 5));
            }
}

BOOST_AUTO_TEST_CASE(random_places_fill_the_cube_evenly) {
    System const system = system_of(Boundary::walls, 4003, 0.1); // eight blocks and a rest
    auto const places = place_at_random(system, 3);
    check_places(system, places);
    double const middle = system.side / 2;
    for (int axis = 0; axis < 3; ++axis) {
        auto const lower = (places.row(axis).array() < middle).count();
        // A binomial of 4003 has standard deviation 32; insertion and even shares lower it.
        BOOST_TEST(std::abs(lower - 2001) < 4 * 32);
        BOOST_TEST(lowest(places) < 0.75 * system.diameter);
        BOOST_TEST(highest(places) > system.side - 0.75 * system.diameter);
    }
}

/// 27 cells in a table of at least four buckets a ball hold seven strangers at most, on average;
/// neighbours are few.
BOOST_AUTO_TEST_CASE(few_balls_are_looked_at_however_wide_the_cube_and_wherever_they_stand) {
    constexpr Eigen::Index count = 2000;
    for (double const side : {1e4, 0x1p20, 1e9}) {
        for (int empty = 0; empty < 3; ++empty) {
            Eigen::Matrix3Xd plane = (side - 1) * Eigen::Matrix3Xd::Random(3, count).cwiseAbs();
            plane.row(empty).setConstant(side / 3);
            Eigen::Matrix3Xd line = plane;
            line.row((empty + 1) % 3).setConstant(side / 7);
            Eigen::Matrix3Xd column = Eigen::Matrix3Xd::Constant(3, count, side / 3);
            column.row(empty) += 1.1 * Eigen::RowVectorXd::LinSpaced(count, 0, count - 1);
            BOOST_TEST_CONTEXT(side << ", axis " << empty) {
                BOOST_TEST(visits_a_ball(side, plane) < 12);
                BOOST_TEST(visits_a_ball(side, line) < 12);
                BOOST_TEST(visits_a_ball(side, column) < 12);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(seeds_differ_and_repeat) {
    System const system = system_of(Boundary::periodic, 100, 0.1);
    BOOST_TEST((place_at_random(system, 1) == place_at_random(system, 1)));
    BOOST_TEST((place_at_random(system, 1) != place_at_random(system, 2)));
}

BOOST_AUTO_TEST_CASE(places_have_these_bits_on_every_machine) {
    BOOST_TEST(hash_of(place_at_random(system_of(Boundary::periodic, 1000, 0.2), 2015)) ==
               15345419833140555956u);
    BOOST_TEST(hash_of(place_at_random(system_of(Boundary::walls, 1000, 0.1), 2015)) ==
               5247727843846573760u);
    BOOST_TEST(hash_of(place_on_fcc(system_of(Boundary::walls, 100, 0.2))) ==
               11340769122612356969u);
    BOOST_TEST(hash_of(place_on_grid(system_of(Boundary::periodic, 100, 0.2))) ==
               13584172153022084825u);
}
