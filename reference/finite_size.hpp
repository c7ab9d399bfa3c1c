#pragma once
// What a run of N balls measures where theory speaks of infinitely many. Units: diameter = kT = 1
// unless said otherwise; kT is twice the kinetic energy over the degrees of freedom
// (System::degrees_of_freedom).

#include <cstdint>

namespace clack::reference {

/// Collisional part of the compressibility factor, Zc = virial / (3 N kT t), of N balls in a
/// periodic cube at constant energy and zero total momentum:
///   Zc(N) = Z - 1 - (rho / 2N) P'' / P'.
/// Leaves out O(1/N^2) and what a ball sees of its own images: up to 0.3 % at N = 32 and number
/// density 0.5 or N = 108 and 0.8 (periodic_md.csv), nothing visible at N = 500.
///   number_density   rho [1 / diameter^3], in the fluid
/// Throws std::invalid_argument where modified_klm does, or unless count > 1.
/// Source: Z. W. Salsburg, J. Chem. Phys. 44, 3090 (1966); J. L. Lebowitz, J. K. Percus,
/// Phys. Rev. 122, 1675 (1961).
double collisional_compressibility(double number_density, std::int64_t count);

/// Compressibility factor that the virial of a periodic run gives: 1 - 1/N + Zc(N). The first two
/// terms are the kinetic part, since the total momentum carries no temperature.
double periodic_compressibility(double number_density, std::int64_t count);

/// Mean |v| of a velocity component at fixed energy over that at fixed temperature, for D degrees
/// of freedom: c_D = sqrt(D/2) Gamma(D/2) / Gamma((D+1)/2) = 1 + 1/(4D) + ...
/// Throws std::invalid_argument unless degrees_of_freedom > 0.
double energy_shell_factor(double degrees_of_freedom);

/// Collisions per ball and unit time: (6 / sqrt(pi)) Zc c_D sqrt(kT/m) / diameter. Exact at every
/// density: the normal relative speed at contact has the same law in all of them.
///   collisional   Zc of this run, finite-size term included
///   Result in sqrt(kT/m) / diameter.
double collision_rate(double collisional, double degrees_of_freedom);

/// The inverse of collision_rate: Zc from the number of collisions, a second way to it beside the
/// virial.
double collisional_from_rate(double rate, double degrees_of_freedom);

} // namespace clack::reference
