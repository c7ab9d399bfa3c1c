#pragma once
// Where a ball is seen. In a periodic cube one that crosses a face is seen at the opposite face
// too, and one in a corner eight times.

#include "state/system.hpp"

#include <Eigen/Core>

namespace clack::view {

/// How far balls stick out of the cube  [sides of the cube]
inline float overhang(System const& system) {
    if (system.boundary == Boundary::walls) return 0;
    return static_cast<float>(system.diameter / system.side / 2);
}

/// Calls visit(place) for each place that a ball is seen at, that of its centre first.
///   position  of its centre, within the cube  [length]
///   place     [sides of the cube]
template <class Visit>
void each_place(System const& system, Eigen::Vector3d const& position, Visit const& visit) {
    Eigen::Vector3f const place = (position / system.side).cast<float>();
    visit(place);
    if (system.boundary == Boundary::walls) return;
    auto const radius = static_cast<float>(system.diameter / system.side / 2);
    Eigen::Vector3f shift = Eigen::Vector3f::Zero(); // to the other side
    for (int axis = 0; axis < 3; ++axis) {
        if (place[axis] < radius) shift[axis] = 1;
        if (place[axis] > 1 - radius) shift[axis] = -1;
    }
    for (int axes = 1; axes < 8; ++axes) { // one bit an axis
        Eigen::Vector3f image = place;
        bool is_seen = true;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(axes >> axis & 1)) continue;
            is_seen = is_seen && shift[axis] != 0;
            image[axis] += shift[axis];
        }
        if (is_seen) visit(image);
    }
}

} // namespace clack::view
