#pragma once
// How long an epoch is.

#include "state/system.hpp"

namespace clack {

/// The power of two that the clock's epoch lasts: a function of the scene alone.
///
/// A ball's place is known to the rounding of its coordinates and of its time, so the way it flies
/// in an epoch should not exceed the cube's side by much; each change of epoch predicts everything
/// afresh, so there should be many collisions between two. The way is 64 mean free paths, half a
/// side at most, unless that holds fewer than 8 mean free paths; then these, four sides at most.
///   speed  root mean square of the start  [length / time]
double epoch_length(System const& system, double speed);

} // namespace clack
