#pragma once
// Engines with one rule exchanged, compiled once for the experiment `power` and the tests.

#include "validation/mutants/engine_maker.hpp"

namespace clack::validation {

/// What is wrong with a mutant. Each is made for the containers in brackets.
enum class Fault {
    wider_balls,        // by 0.1 % (periodic)
    stronger_impulses,  // by 1e-4 (periodic)
    weaker_impulses,    // by 1e-4 (walls)
    missed_collisions,  // one in 10^4 (periodic)
    late_collisions,    // one in 10^5, by 1e-6 (periodic)
    earlier_normal,     // the line of centres 0.01 before contact (periodic)
    rounded_velocities, // to 32 bits (periodic)
    moved_walls,        // by 0.1 % (walls)
    lossy_walls,        // of restitution 0.9999 (walls)
    lost_refresh,       // with cells (periodic)
    stale_images,       // with every pair, the nearest image of the start only (periodic)
    layered_start,      // velocities in two dimensions, and no way into the third (walls)
    unequal_speeds      // every other ball 5 % faster at the start, the others slower (walls)
};

/// Starts scenes with a mutant; throws std::invalid_argument for a container that it is not made
/// for.
EngineMaker with(Fault fault);

/// The fault in a few words.
char const* name_of(Fault fault);

} // namespace clack::validation
