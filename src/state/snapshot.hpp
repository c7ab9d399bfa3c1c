#pragma once
// The balls at one instant, for files, pictures and observables.

#include <Eigen/Core>

#include <cstdint>

namespace clack {

/// All balls at one time, column i being ball number i, whatever order the engine keeps them in.
struct Snapshot {
    double time = 0;                   // since the run's time 0
    std::uint64_t ball_collisions = 0; // ball-ball collisions since time 0
    Eigen::Matrix3Xd positions;        // [length]; periodic: wrapped into [0, side]
    Eigen::Matrix3Xd velocities;       // [length / time]
    Eigen::Matrix3Xi images;           // periodic: position + image * side is the unwrapped place
};

/// Where a run starts: places and velocities, column i being ball number i.
struct Start {
    Eigen::Matrix3Xd positions;
    Eigen::Matrix3Xd velocities;
};

} // namespace clack
