#pragma once
// Pressure of an infinite fluid of equal hard balls. Units: diameter = kT = 1.

namespace clack::reference {

/// The pressure and its first two derivatives with respect to the number density.
struct Pressure {
    double value;     // P(rho)    [kT / diameter^3]
    double slope;     // dP/drho   [kT]
    double curvature; // d2P/drho2 [kT diameter^3]
};

/// Compressibility factor Z = P V / (N kT) of the fluid, modified Kolafa-Labik-Malijevsky: twelve
/// terms in x = eta / (1 - eta) fitted to molecular dynamics, with the exact second to fourth
/// virial coefficients.
/// Relative error 2e-5 up to number density 1.0 (the stable fluid ends at 0.939): the distance to
/// Schultz's independent fit of independent data (eos_fluid_values.csv).
///   packing_fraction   eta = pi rho / 6
/// Throws std::invalid_argument outside [0, 0.54], where the fit has no data.
/// Source: coefficients as in M. N. Bannerman's pyenskog; S. Pieprzyk, M. N. Bannerman,
/// A. C. Branka, M. Chudak, D. M. Heyes, Phys. Chem. Chem. Phys. 21, 6886 (2019),
/// doi:10.1039/C9CP00903E, after J. Kolafa, S. Labik, A. Malijevsky, Phys. Chem. Chem. Phys. 6,
/// 2335 (2004), doi:10.1039/B402792B.
double modified_klm(double packing_fraction);

/// The pressure P = rho Z of modified_klm and its derivatives, differentiated term by term.
///   number_density   rho [1 / diameter^3]
/// Range and errors as modified_klm.
Pressure modified_klm_pressure(double number_density);

/// Compressibility factor of the fluid by Schultz's fit of his own runs: an exponential of a
/// polynomial in the density, whose low orders are the virial coefficients. Independent of
/// modified_klm; range, error and refusals the same.
/// Source: A. J. Schultz, HardSphereFluid.java of etomica (github etomica/etomica, commit
/// acd32268).
double schultz_fluid(double packing_fraction);

/// Compressibility factor of Carnahan and Starling, (1 + eta + eta^2 - eta^3) / (1 - eta)^3.
/// Low by up to 0.26 % in the fluid (at number density 0.8): a guide line, not a yardstick.
/// Throws std::invalid_argument outside [0, 1).
/// Source: N. F. Carnahan, K. E. Starling, J. Chem. Phys. 51, 635 (1969).
double carnahan_starling(double packing_fraction);

} // namespace clack::reference
