#pragma once
// Balls at random places.

#include "state/system.hpp"

#include <Eigen/Core>

#include <cstdint>

namespace clack {

/// Random places without overlap, the same for the same seed on every machine. Dilute: one ball
/// after the other, each drawn again until it is free (random sequential insertion). Denser:
/// smaller balls are inserted and grown (grow_balls). Throws LawBroken when they jam.
Eigen::Matrix3Xd place_at_random(System const& system, std::uint64_t seed);

} // namespace clack
