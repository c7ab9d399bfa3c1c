#pragma once
// Whether the balls are a crystal.

#include "state/snapshot.hpp"
#include "state/system.hpp"

namespace clack {

/// Steinhardt's global bond order Q6 of the bonds between balls nearer than reach: 0.57452 for a
/// face-centred cubic lattice, 0.48476 for a hexagonal close-packed one, of the order of
/// 1 / sqrt(bonds) in a fluid, where bonds point anywhere; 0 without bonds.
/// Two nearest images of one pair count as one bond: reach should stay below half of the side.
/// Source: P. J. Steinhardt, D. R. Nelson, M. Ronchetti, Phys. Rev. B 28, 784 (1983).
double bond_order(System const& system, Snapshot const& snapshot, double reach);

} // namespace clack
