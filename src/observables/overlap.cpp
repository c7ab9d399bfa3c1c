#include "observables/overlap.hpp"

#include "observables/near_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clack {

Overlap deepest_overlap(System const& system, Eigen::Matrix3Xd const& positions) {
    NearCells const cells(system, positions, system.diameter);
    Overlap deepest;
    cells.each_pair([&](Eigen::Index i, Eigen::Index j, Eigen::Vector3d const& separation) {
        double const depth = 1 - separation.norm() / system.diameter;
        if (depth > deepest.depth) deepest = {depth, i, j};
    });
    return deepest;
}

Excursion farthest_outside(System const& system, Eigen::Matrix3Xd const& positions) {
    double const margin = system.boundary == Boundary::walls ? system.diameter / 2 : 0;
    Excursion farthest;
    for (Eigen::Index i = 0; i < positions.cols(); ++i) {
        for (double const place : positions.col(i)) {
            double const beyond = std::isfinite(place)
                                      ? std::max(margin - place, place - (system.side - margin))
                                      : std::numeric_limits<double>::infinity();
            if (beyond > farthest.distance) farthest = {beyond, i};
        }
    }
    return farthest;
}

} // namespace clack
