#include "observables/bond_order.hpp"

#include "observables/near_cells.hpp"

#include <gsl/gsl_sf_legendre.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace clack {

double bond_order(System const& system, Snapshot const& snapshot, double const reach) {
    constexpr int degree = 6; // even: a bond has no direction
    std::array<std::complex<double>, degree + 1> sums{};
    std::int64_t bonds = 0;
    NearCells const cells(system, snapshot.positions, reach);
    cells.each_pair([&](Eigen::Index, Eigen::Index, Eigen::Vector3d const& separation) {
        double const distance = separation.norm();
        if (!(distance < reach)) return;
        ++bonds;
        double const azimuth = std::atan2(separation.y(), separation.x());
        for (int m = 0; m <= degree; ++m)
            sums[static_cast<std::size_t>(m)] +=
                gsl_sf_legendre_sphPlm(degree, m, separation.z() / distance) *
                std::polar(1.0, m * azimuth);
    });
    if (bonds == 0) return 0;
    double squares = std::norm(sums[0]);
    for (int m = 1; m <= degree; ++m) squares += 2 * std::norm(sums[static_cast<std::size_t>(m)]);
    return std::sqrt(4 * std::numbers::pi / (2 * degree + 1) * squares) /
           static_cast<double>(bonds);
}

} // namespace clack
