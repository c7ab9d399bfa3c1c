#include "observables/overlap.hpp"

#include <boost/test/unit_test.hpp>

#include <gsl/gsl_rng.h>

#include <cmath>
#include <limits>
#include <memory>

using namespace clack;

namespace {

Eigen::Matrix3Xd random_places(Eigen::Index count, double side, unsigned long seed) {
    std::unique_ptr<gsl_rng, void (*)(gsl_rng*)> const rng(gsl_rng_alloc(gsl_rng_mt19937),
                                                           gsl_rng_free);
    gsl_rng_set(rng.get(), seed);
    Eigen::Matrix3Xd places(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (double& place : places.col(i)) place = side * gsl_rng_uniform(rng.get());
    }
    return places;
}

/// Over every pair and all nearest images.
Overlap over_every_pair(System const& system, Eigen::Matrix3Xd const& places) {
    Overlap deepest;
    for (Eigen::Index i = 0; i < places.cols(); ++i) {
        for (Eigen::Index j = i + 1; j < places.cols(); ++j) {
            Eigen::Vector3d apart = places.col(j) - places.col(i);
            if (system.boundary == Boundary::periodic) {
                for (double& d : apart) d = std::remainder(d, system.side);
            }
            double const depth = 1 - apart.norm() / system.diameter;
            if (depth > deepest.depth) deepest = {depth, i, j};
        }
    }
    return deepest;
}

} // namespace

BOOST_AUTO_TEST_CASE(cells_find_what_every_pair_finds) {
    for (auto const boundary : {Boundary::walls, Boundary::periodic}) {
        for (double const side : {1.5, 2.9, 3.1, 7.0, 20.0}) {
            for (unsigned long seed = 1; seed <= 20; ++seed) {
                System const system{boundary, side, 40, 1, 1};
                auto const places = random_places(40, side, seed);
                auto const found = deepest_overlap(system, places);
                auto const expected = over_every_pair(system, places);
                BOOST_TEST(found.depth == expected.depth, boost::test_tools::tolerance(1e-14));
                BOOST_TEST(found.first == expected.first);
                BOOST_TEST(found.second == expected.second);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(touching_balls_do_not_overlap) {
    Eigen::Matrix3Xd places(3, 2);
    places << 1, 2, 1, 1, 1, 1;
    BOOST_TEST(deepest_overlap({Boundary::walls, 5, 2, 1, 1}, places).depth == 0);
}

BOOST_AUTO_TEST_CASE(ball_outside_is_named) {
    System const walls{Boundary::walls, 5, 2, 1, 1}, periodic{Boundary::periodic, 5, 2, 1, 1};
    Eigen::Matrix3Xd places(3, 2);
    places << 2, 4.6, 2, 0.5, 2, 0.5;
    auto const outside = farthest_outside(walls, places);
    BOOST_TEST(outside.ball == 1);
    BOOST_TEST(outside.distance == 0.1, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(farthest_outside(periodic, places).ball == -1);
    places(1, 0) = std::numeric_limits<double>::quiet_NaN();
    BOOST_TEST(farthest_outside(periodic, places).ball == 0);
    BOOST_TEST(std::isinf(farthest_outside(periodic, places).distance));
}
