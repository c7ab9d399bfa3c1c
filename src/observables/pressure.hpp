#pragma once
// Temperature and pressure from what a run has added up, by two independent routes: the virial of
// the collisions between balls and, with walls, the impulses on the walls.

#include "observables/blocking.hpp"
#include "state/checkpoint.hpp"
#include "state/system.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace clack {

/// What a run has counted since time 0 at one instant, and the energy it then had.
struct Sample {
    double time = 0; // since the run's time 0
    Tallies tallies;
    double kinetic_energy = 0;
};

/// kT of a run of constant energy, from the degrees of freedom that it has. A periodic run keeps
/// its momentum, so the motion of the whole carries no heat.
///   kinetic_energy  [energy]
///   momentum        [mass length / time]; ignored with walls
/// Returns 0 where no degree of freedom is left (one ball, periodic).
double temperature(System const& system, double kinetic_energy, Eigen::Vector3d const& momentum);

/// P V / (N kT), V being for walls the volume that the centres can reach.
struct CompressibilityFactor {
    std::optional<Estimate> virial; // none for one ball in a periodic cube
    std::optional<Estimate> wall;   // with walls only
};

/// From the samples of a run, the first of which is its start.
/// Periodic: 1 - 1/N + W / (3 N kT t) with the virial W, since the momentum is 0: the exact law of
/// the ensemble at this N; it differs from the infinite fluid's by terms of order 1/N.
/// Walls: 1 + W / (3 N kT t), and independently P l / (N kT) l^2 from the impulses.
///   kt  from `temperature`; must be positive, else no value is given
CompressibilityFactor compressibility_factor(System const& system, double kt,
                                             std::vector<Sample> const& samples);

/// Force on the six walls over their area 6 (side - diameter)^2.  [mass / (length time^2)]
/// None for a periodic cube.
std::optional<Estimate> wall_pressure(System const& system, std::vector<Sample> const& samples);

} // namespace clack
