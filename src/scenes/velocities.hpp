#pragma once
// How fast the balls are at the start.

#include "state/system.hpp"

#include <Eigen/Core>

#include <cstdint>

namespace clack {

/// Components drawn from the normal distribution: Maxwell's law. The same for the same seed on
/// every machine. With periodic boundaries the total momentum is removed (a single ball keeps its
/// own); then all are scaled so that m sum v^2 = degrees_of_freedom kT to rounding.
Eigen::Matrix3Xd draw_maxwell_velocities(System const& system, double temperature,
                                         std::uint64_t seed);

/// Directions uniform over the sphere, all speeds equal but for the momentum that is removed with
/// periodic boundaries; scaled in the same way.
Eigen::Matrix3Xd draw_equal_speeds(System const& system, double temperature, std::uint64_t seed);

/// kT of these velocities: m sum v^2 / degrees_of_freedom, summed with compensation.
double temperature_of(System const& system, Eigen::Matrix3Xd const& velocities);

} // namespace clack
