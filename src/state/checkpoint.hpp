#pragma once
// Everything that a run needs to go on to the same bits.

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace clack {

/// What a run has counted and added up since time 0.
struct Tallies {
    std::uint64_t ball_collisions = 0;
    std::uint64_t wall_collisions = 0;
    double virial = 0; // sum over ball collisions of separation . impulse  [energy]
    double wall_impulse =
        0; // sum over wall collisions of |impulse|             [mass length / time]
    double deepest_overlap = 0; // 1 - distance / diameter at the worst contact      [diameters]
};

/// The state of an engine between two events. A number of the run's floating type is kept as
/// `limbs` doubles whose exact sum it is (limb_count in real.hpp), so the first limb is the number
/// rounded to double.
struct Checkpoint {
    int limbs = 1;
    double epoch_length = 1;     // a power of two  [time]
    std::int64_t epoch = 0;      // epochs since the clock's zero
    std::vector<double> offset;  // clock within the epoch: limbs numbers
    std::vector<double> records; // count x 7 x limbs: point, velocity, time within the epoch
    Eigen::Matrix3Xi images;     // count columns
    Tallies tallies;
    std::uint64_t hash = 0; // of the collision sequence so far
};

} // namespace clack
