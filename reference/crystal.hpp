#pragma once
// The face-centred cubic crystal of equal hard balls, infinitely many of them, and its coexistence
// with the fluid. Units: diameter = kT = 1.

#include <cstdint>

namespace clack::reference {

/// Packing fraction of close packing, pi / (3 sqrt 2).
double close_packing_fraction();

/// Compressibility factor of the crystal, Schultz's fit: 3/y + a polynomial in y, y being 1 minus
/// the density over that of close packing.
/// Relative error 3e-4 from number density 1.04 to close packing, 6e-4 down to 1.0: the distance to
/// Speedy's independent fit (eos_crystal_values.csv).
/// Throws std::invalid_argument outside [0.52, close packing).
/// Source: A. J. Schultz, HardSphereSolid.java of etomica (github etomica/etomica).
double schultz_crystal(double packing_fraction);

/// The same by Speedy: 3/(1-z) - a (z-b)/(z-c), z = density over that of close packing,
/// a = 0.5921, b = 0.7072, c = 0.601. Range, error and refusals as schultz_crystal.
/// Source: R. J. Speedy, J. Phys.: Condens. Matter 10, 4387 (1998).
double speedy_crystal(double packing_fraction);

/// Compressibility factor that the virial of a periodic run of N balls gives: the free volume of
/// the N - 1 that are left when one holds the place of all makes the leading term, 3/y, one of
/// 3 (1 - 1/N)/y. Exact at close packing (Z. W. Salsburg, W. W. Wood, J. Chem. Phys. 37, 798
/// (1962)); further away other terms of order 1/N are left out.
/// Throws std::invalid_argument where schultz_crystal does.
double periodic_crystal(double packing_fraction, std::int64_t count);

/// Free energy of the crystal beyond the ideal gas's, A_ex / (N kT), at one number density.
/// Source: as schultz_crystal, which quotes doi:10.1063/1.4818990; error 3e-5.
constexpr double crystal_free_energy = 5.91901;
constexpr double crystal_free_energy_density = 1.0409;

/// Pressure at which fluid and crystal coexist [kT / diameter^3], and its error.
/// Source: L. A. Fernandez, V. Martin-Mayor, B. Seoane, P. Verrocchio, Phys. Rev. Lett. 108, 165701
/// (2012), arXiv:1103.2599. Equal chemical potentials of modified_klm and schultz_crystal meet
/// 0.005 lower.
constexpr double coexistence_pressure = 11.5727;
constexpr double coexistence_pressure_error = 0.005;

} // namespace clack::reference
