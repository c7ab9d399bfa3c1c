#pragma once
// Whether the balls of one instant keep out of each other and inside their cube, from places alone:
// nothing of the engine's is used.

#include "state/system.hpp"

#include <Eigen/Core>

#include <cstdint>

namespace clack {

/// The two balls that overlap most.
struct Overlap {
    double depth = 0; // 1 - distance / diameter; 0 when no two balls overlap
    std::int64_t first = -1, second = -1;
};

/// Over nearest images where the cube is periodic. Takes a time proportional to the count.
Overlap deepest_overlap(System const& system, Eigen::Matrix3Xd const& positions);

/// The ball that is farthest out.
struct Excursion {
    double distance = 0; // beyond what its centre may reach [length]; 0 when all are inside
    std::int64_t ball = -1;
};

/// A place that is not a number is infinitely far out.
Excursion farthest_outside(System const& system, Eigen::Matrix3Xd const& positions);

} // namespace clack
