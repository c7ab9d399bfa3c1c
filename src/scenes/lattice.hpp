#pragma once
// Balls in rows: the simple cubic grid and the face-centred cubic lattice.

#include "state/system.hpp"

#include <Eigen/Core>

namespace clack {

/// Centres of the first `count` of m^3 equal cells, m being the smallest that suffices; x runs
/// fastest. The report's start for looking at single collisions.
Eigen::Matrix3Xd place_on_grid(System const& system);

/// Sites of the smallest fcc lattice that holds all balls; surplus sites are left empty evenly.
/// x runs fastest.
Eigen::Matrix3Xd place_on_fcc(System const& system);

} // namespace clack
