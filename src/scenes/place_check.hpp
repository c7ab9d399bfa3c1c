#pragma once
// The rules that places must obey before a run can start.

#include "state/system.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>

namespace clack {

/// Brings places with periodic boundaries into [0, side); those inside keep their bits.
void wrap_places(System const& system, Eigen::Matrix3Xd& places);

/// A ball that stands where it must not.
struct Misplaced {
    Eigen::Index ball; // of a pair the later one
    std::string what;  // the ball by number, its place or the other ball, the rule, what to do
};

/// What is wrong with the places: a coordinate that is no finite number, a ball that sticks out of
/// the cube, or the deepest overlap. Nothing when all is well; balls that touch to rounding are.
std::optional<Misplaced> misplaced_ball(System const& system, Eigen::Matrix3Xd const& places);

} // namespace clack
