#pragma once
// Balls that never leave a plane or a line, as those of a cradle: the laws of a gas in space are
// not theirs.

#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <string>

namespace clack::view {

/// In how many of the cube's three directions balls move or ever will. Some direction is left out
/// when no ball moves along it and balls that can touch are level in it, so that no collision
/// pushes along it either: exact, though not every row that slants is found.
int directions_of_motion(System const& system, Snapshot const& now);

/// Why the speeds of so many balls do not come to their law in space, in words; empty where they
/// do.
std::string why_without_law(std::int64_t count, int directions);

} // namespace clack::view
