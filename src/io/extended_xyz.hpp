#pragma once
// Frames as extended XYZ, the text that OVITO, ASE and others read.

#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <ostream>

namespace clack {

/// One frame: species X, the cube as lattice, position, velocity, radius and number of each ball,
/// with the 17 digits that bring back every bit. Positions in the cube; images are not in it.
void write_extended_xyz(std::ostream& out, System const& system, Snapshot const& frame);

} // namespace clack
