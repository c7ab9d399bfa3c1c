#pragma once
// Dense random starts: balls that grow while they move (Lubachevsky and Stillinger, J. Stat. Phys.
// 60, 561 (1990)).

#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <cstdint>

namespace clack {

/// Moves balls that start with `start_diameter` and grow at a steady rate until they have the
/// system's diameter. Only + - * / and sqrt are used, so the result is the same on every machine.
///   target          the system as it is to be; its boundary and side hold throughout
///   positions       [length], free of overlap at start_diameter
///   start_diameter  [length], below target.diameter
///   seed            of the velocities that the balls move with while they grow
/// Returns places without overlap at target.diameter. Throws LawBroken when the balls jam first.
Eigen::Matrix3Xd grow_balls(System const& target, Eigen::Matrix3Xd const& positions,
                            double start_diameter, std::uint64_t seed);

} // namespace clack
