#pragma once
// What every arrangement must satisfy, checked pair by pair without the help of any grid.

#include "state/system.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace clack::test {

inline double lowest(Eigen::Matrix3Xd const& columns) {
    return *std::min_element(columns.data(), columns.data() + columns.size());
}
inline double highest(Eigen::Matrix3Xd const& columns) {
    return *std::max_element(columns.data(), columns.data() + columns.size());
}

/// Distance of two places by the nearest of all 27 images.
inline double distance(System const& system, Eigen::Vector3d const& a, Eigen::Vector3d const& b) {
    double nearest = (a - b).norm();
    if (system.boundary == Boundary::periodic)
        for (int image = 0; image < 27; ++image) {
            Eigen::Vector3d const shift(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
            nearest = std::min(nearest, (a - b + shift * system.side).norm());
        }
    return nearest;
}

/// Every ball inside, no pair nearer than a diameter, both to rounding of the side.
inline void check_places(System const& system, Eigen::Matrix3Xd const& places) {
    double const rounding = 4 * std::numeric_limits<double>::epsilon() * system.side;
    double const rim = system.boundary == Boundary::walls ? system.diameter / 2 : 0;
    BOOST_TEST(places.cols() == system.count);
    BOOST_TEST(lowest(places) >= rim - rounding);
    BOOST_TEST(highest(places) <= system.side - rim + rounding);
    double nearest = system.diameter;
    for (Eigen::Index i = 0; i < places.cols(); ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            nearest = std::min(nearest, distance(system, places.col(i), places.col(j)));
    BOOST_TEST(nearest >= system.diameter - rounding);
}

/// FNV-1a over the bits of all coordinates.
inline std::uint64_t hash_of(Eigen::Matrix3Xd const& columns) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (double const x : columns.reshaped())
        for (int byte = 0; byte < 8; ++byte)
            hash = (hash ^ (std::bit_cast<std::uint64_t>(x) >> (8 * byte) & 0xff)) * 0x100000001b3u;
    return hash;
}

} // namespace clack::test
