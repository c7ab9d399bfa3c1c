#pragma once
// Pressure of a fluid of equal hard balls between six hard walls. Units: diameter = kT = 1.

namespace clack::reference {

/// Compressibility factor P l^3 / (N kT), l = side - 1 being the side of the cube that the centres
/// can reach, of N balls in a cube with hard walls; P is the mean pressure on the walls.
/// The plane that the centres can reach has, by scaled particle theory, the tension
///   gamma = -(9 / 2 pi) eta^2 (1 + eta) / (1 - eta)^3   [kT / diameter^2].
/// A face of area A thus holds -A dgamma/dmu balls beyond the density of the bulk, which so follows
/// from N; the bulk's pressure is modified_klm's; and the walls feel P = P(bulk) - gamma dA/dV, as
/// a bubble's would, with dA/dV = 4 / l. Exact to the first order in density and in 1 / l. Edges
/// and corners, terms of order 1 / l^2, are left out: some 0.1 % in a cube of twenty diameters at
/// number density 0.1, up to 1 % in a dense fluid.
///   side    wall to wall [diameter]
///   count   N
/// Throws std::invalid_argument where modified_klm does, with fewer than two balls, and for cubes
/// of less than five diameters, whose middle is no bulk. Source: H. Reiss, H. L. Frisch, E.
/// Helfand, J. L. Lebowitz, J. Chem. Phys. 32, 119 (1960).
double walled_compressibility(double side, double count);

/// What the walls of a cube of N balls feel at constant energy, kT = 2E / (3N), term by term.
struct WalledCubePressure {
    double bulk_density; // in the middle [1 / diameter^3]
    double bulk;         // P of that density [kT / diameter^3], as are the following
    double faces;        // - 4 gamma / l, l = side - 1
    double edges;        // - 4 tau / l^2
    double canonical;    // - (rho / 2V) P'' / P': the number of balls does not fluctuate

    double total() const { return bulk + faces + edges + canonical; }
};

/// Adsorption and tension of faces and edges are those of wall_tension.csv; the density of the bulk
/// follows from N = rho l^3 + 6 l^2 Gamma + 12 l Gamma_edge. Corners are left out.
/// The total is right to 0.1 % for l from 6 to 20 and bulk densities of 0.19 to 0.69
/// (walled_cube_md.csv). The tension is measured; what edges add above the lowest order of density
/// is an estimate, and less than 2 % of the whole there.
///   side    wall to wall [diameter], at least 5
///   count   N
/// Throws std::invalid_argument for smaller cubes, and for a bulk denser than 0.92.
WalledCubePressure walled_cube_pressure(double side, double count);

} // namespace clack::reference
