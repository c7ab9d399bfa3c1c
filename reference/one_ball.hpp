#pragma once
// One ball alone in a cube with walls: three triangle waves.

#include "reference/triangle_wave.hpp"
#include "state/system.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace clack::reference {

/// The exact motion of one ball in a cube with walls.
class OneBall {
public:
    ///   system     with walls; its count is not looked at
    ///   position   of the centre at time 0 [length]
    ///   velocity   at time 0 [length / time]
    /// Throws std::invalid_argument when the ball sticks out of the cube.
    OneBall(System const& system, Eigen::Vector3d const& position, Eigen::Vector3d const& velocity);

    Eigen::Vector3d position(double time) const;
    Eigen::Vector3d velocity(double time) const;
    std::int64_t wall_collisions(double time) const; // in (0, time]
    /// Force on each wall across an axis, m v^2 / l, averaged over whole periods.
    Eigen::Vector3d mean_wall_force() const;

private:
    System system_;
    std::array<TriangleWave, 3> axes_;
};

} // namespace clack::reference
