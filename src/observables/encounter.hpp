#pragma once
// How two balls met: the geometry of one collision.

#include "resolution/collision.hpp"

#include <Eigen/Core>

namespace clack {

struct Encounter {
    double normal_speed;             // along the line of centres [length / time]
    double impact_parameter_squared; // in diameters squared: 0 head-on, 1 grazing
    Eigen::Vector3d line_of_centres; // unit vector from the first ball to the second
};

/// Of a collision between balls. The normal component of the relative velocity changes its sign
/// and the tangential one stays, so what leaves tells what came.
inline Encounter encounter_of(Collision<double> const& collision) {
    Eigen::Vector3d const line = collision.separation.normalized();
    Eigen::Vector3d const relative = collision.velocity_second - collision.velocity_first;
    double const normal = line.dot(relative);
    return {normal, (relative - normal * line).squaredNorm() / relative.squaredNorm(), line};
}

} // namespace clack
