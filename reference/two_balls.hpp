#pragma once
// Two equal balls in a cube with hard walls: the one case in which the pressure is known exactly.

namespace clack::reference {

/// Two balls that share an energy in a cube with walls. All means are over the constant-energy
/// ensemble, that is over a long time, the motion being ergodic.
struct TwoBalls {
    double side = 3;           // wall to wall [length]
    double diameter = 1;       // [length]
    double mass = 1;           // of one ball [mass]
    double kinetic_energy = 3; // of both [energy]; kT is a third of it

    /// Side of the cube that the centres can reach [length].
    double accessible_side() const { return side - diameter; }
    double temperature() const { return kinetic_energy / 3; }
    /// Mean force on one wall [energy / length]: (kT/l) [2 + x p'(x) / (3 (1 - p(x)))], with x
    /// the diameter over the accessible side l and p = nearer_probability.
    double wall_force() const;
    /// Mean force over the area that the centres can reach, l^2 [energy / length^3].
    double wall_pressure() const;
    /// Collisions of the pair per unit time [1 / time].
    double collision_rate() const;
};

/// Probability that two points thrown at random into a unit cube are nearer than x:
/// (4 pi/3) x^3 - (3 pi/2) x^4 + (8/5) x^5 - x^6/6.
/// Throws std::invalid_argument unless 0 <= x <= 1; so do the means above, which want a side of at
/// least two diameters.
double nearer_probability(double x);

/// Its derivative, the density of the distance.
double nearer_density(double x);

} // namespace clack::reference
