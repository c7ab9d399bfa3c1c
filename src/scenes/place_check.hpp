#pragma once
// The rules that places must obey before a run can start.

#include "state/system.hpp"

#include <Eigen/Core>

#include <string>

namespace clack {

/// Brings places with periodic boundaries into [0, side); those inside keep their bits.
void wrap_places(System const& system, Eigen::Matrix3Xd& places);

/// What is wrong with the places, or nothing: a coordinate that is no finite number, a ball that
/// sticks out of the cube, the deepest overlap. Balls that touch to rounding are fine.
std::string why_places_are_wrong(System const& system, Eigen::Matrix3Xd const& places);

} // namespace clack
