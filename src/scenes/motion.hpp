#pragma once
// Whether a run that starts with these speeds can reach what is asked of it.

#include "scenes/key.hpp"
#include "scenes/scene.hpp"

#include <optional>
#include <string>

namespace clack {

/// A rule that a key's value breaks.
struct Objection {
    Key key;
    std::string value, rule;
};

/// What stands in the way of a run whose fastest ball has this speed: a goal counted in collisions
/// where none will ever happen, a speed that the precision cannot hold, more crossings of the cube
/// than the clock counts, frames closer in time than it can tell apart.
std::optional<Objection> objection_to_motion(Scene const& scene, double fastest);

/// Speed of the fastest ball, as the scene alone gives it; of drawn velocities the root mean
/// square. Nothing where the velocities are in a file.
std::optional<double> expected_speed(Scene const& scene);

/// The largest of the columns' lengths.
double fastest_speed(Eigen::Matrix3Xd const& velocities);

} // namespace clack
