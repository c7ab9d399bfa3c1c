#pragma once
// Transport in a fluid of hard balls after Enskog. Units: diameter = mass = kT = 1.

namespace clack::reference {

/// Enskog's coefficients with Sonine polynomials of all orders. Exact in the limit of density zero,
/// where the bulk viscosity vanishes; beyond, collisions are taken as uncorrelated but for the
/// contact value, so that they are guide lines above a packing fraction of about 0.1:
/// self-diffusion is then off by up to a third (number density 0.5), the shear viscosity by a
/// factor of about 2 near freezing. Throws std::invalid_argument where modified_klm does. Source:
/// S. Chapman, T. G. Cowling, The Mathematical Theory of Non-Uniform Gases (Cambridge, 1970), 16.;
/// the factors of all orders C. L. Pekeris, Z. Alterman, Proc. Natl. Acad. Sci. 43, 998 (1957),
/// confirmed by an expansion to seven terms to 3e-6.
struct Enskog {
    explicit Enskog(double packing_fraction);

    double collision_rate;       // of a ball [1 / time]
    double self_diffusion;       // [length^2 / time]
    double shear_viscosity;      // [mass / (length time)]
    double bulk_viscosity;       // the same
    double thermal_conductivity; // [k / (length time)]
};

/// What the polynomials beyond the first add.
constexpr double self_diffusion_all_orders = 1.018954;
constexpr double shear_viscosity_all_orders = 1.016034;
constexpr double thermal_conductivity_all_orders = 1.025218;

/// What constant energy and no total momentum leave of the mean square of the flux of momentum and
/// of heat through a dilute gas of so many balls, and so of its shear viscosity and its thermal
/// conductivity: (1 - 1/n) D / (D + 2) and (1 - 1/n) (1 - 2/n) D^2 / ((D + 2) (D + 4)) with
/// D = 3n - 3, exactly. The rate at which the fluxes decay has no such term where it does not
/// depend on speed (Maxwell's molecules). Source: moments of velocities that are uniform on that
/// shell.
double momentum_flux_of(double count);
double heat_flux_of(double count);

/// Self-diffusion of about 500 balls in a periodic cube, a fit to simulations: a guide line, low by
/// 1 % at number density 0.5 and 4 % at 0.9.
/// Source: R. J. Speedy, Mol. Phys. 62, 509 (1987), doi:10.1080/00268978700102371.
double speedy_self_diffusion(double number_density);

/// What a periodic cube takes off the self-diffusion of infinitely many balls,
///   2.837297 kT / (6 pi (viscosity + rho D) side):
/// the long-time tail less its sum over the waves that fit into the cube. Yeh and Hummer leave out
/// rho D, as one may where momentum spreads much faster than balls; in a gas it does not.
///   viscosity         shear viscosity [mass / (length time)]
///   number_density    rho
///   self_diffusion    D
/// Source: I.-C. Yeh, G. Hummer, J. Phys. Chem. B 108, 15873 (2004), doi:10.1021/jp0477147, and the
/// integral over time of long_time_tail.
double periodic_diffusion_deficit(double viscosity, double number_density, double self_diffusion,
                                  double side);

/// The long-time tail of the velocity autocorrelation over its value at 0,
/// 2 / (3 rho) [4 pi (D + viscosity / rho) time]^(-3/2), of infinitely many balls.
/// Source: M. H. Ernst, E. H. Hauge, J. M. J. van Leeuwen, Phys. Rev. Lett. 25, 1254 (1970),
/// doi:10.1103/PhysRevLett.25.1254.
double long_time_tail(double number_density, double self_diffusion, double shear_viscosity,
                      double time);

/// The same of so many balls in a periodic cube: the sum over the transverse waves that fit into
/// it, without the one of infinite length, which is the momentum and does not decay; and what the
/// sound waves lack for the same reason, until they have crossed the cube.
double long_time_tail_in_box(double count, double side, double self_diffusion,
                             double kinematic_viscosity, double time);

} // namespace clack::reference
