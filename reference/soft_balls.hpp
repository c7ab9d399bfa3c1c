#pragma once
// Elastic balls that push each other apart with a linear spring while they overlap (Hooke): how
// long they touch, and which hard balls they stand for. Units: diameter = mass = 1.

#include <cmath>
#include <numbers>

namespace clack::reference {

/// How long two balls touch in a head-on collision, half a period of the spring: pi sqrt(m / 2k). A
/// ball touches a wall as long whose stiffness is 2k.
///   stiffness   k of a pair  [mass / time^2]
inline double contact_duration(double const stiffness) {
    return std::numbers::pi / std::sqrt(2 * stiffness);
}

/// The same when time is stepped by leapfrog, which swings a little too fast: the leading term in
/// the number of steps that a contact lasts, below 1 % from 8 steps on.
inline double stepped_contact_duration(double const stiffness, double const steps_per_contact) {
    double const part = std::numbers::pi / steps_per_contact;
    return contact_duration(stiffness) * (1 - part * part / 24);
}

/// Diameter of the hard balls whose fluid has the pressure of the soft ones, to first order in
/// k^(-1/2): d less the integral of exp(-potential / kT) over the overlap, sqrt(pi kT / 2k).
/// Source: J. A. Barker, D. Henderson, J. Chem. Phys. 47, 4714 (1967), doi:10.1063/1.1701689.
inline double barker_henderson_diameter(double const diameter, double const stiffness,
                                        double const kt) {
    return diameter - std::sqrt(std::numbers::pi * kt / (2 * stiffness));
}

} // namespace clack::reference
