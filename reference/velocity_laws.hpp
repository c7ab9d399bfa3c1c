#pragma once
// How fast the balls are: the exact laws of finitely many balls at constant energy, and their
// limit.

#include "state/system.hpp"

namespace clack::reference {

/// The law of one ball's velocity when all velocities are spread evenly over the sphere of constant
/// energy (and, in a periodic cube, of total momentum 0). With n degrees of freedom and
/// s = N/(N-1) periodic or 1 with walls,
///   q = s m v^2 / (2E)   is Beta(3/2, (n-3)/2),   of one component Beta(1/2, (n-1)/2).
/// Source: E. Scalas, A. T. Gabriel, E. Martin, G. Germano, Phys. Rev. E 92, 022140 (2015).
class VelocityLaw {
public:
    ///   kinetic_energy   of all balls [energy], positive
    /// Throws std::invalid_argument with fewer than two balls between walls or three in a periodic
    /// cube: there the speeds of a ball do not have this law, or no density.
    VelocityLaw(System const& system, double kinetic_energy);

    double speed_density(double speed) const;             // [1 / speed]
    double speed_probability(double speed) const;         // of a speed up to this one
    double speed_quantile(double probability) const;      // its inverse
    double component_density(double component) const;     // [1 / speed]
    double component_probability(double component) const; // of a component up to this one
    double top_speed() const { return top_speed_; }       // one ball has all it can have
    double mean_square_speed() const;                     // 2E / (mN)
    /// <v^4> / <v^2>^2 = (5/3) n / (n + 2).
    double fourth_moment_ratio() const;

private:
    double degrees_of_freedom_;
    double top_speed_;
};

/// The limit of infinitely many balls (Maxwell and Boltzmann): each component is normal with
/// variance kT/m.
class MaxwellBoltzmann {
public:
    /// Throws std::invalid_argument unless both are positive.
    MaxwellBoltzmann(double temperature, double mass);

    double speed_density(double speed) const;
    double speed_probability(double speed) const;
    double component_density(double component) const;
    double component_probability(double component) const;
    static constexpr double fourth_moment_ratio = 5.0 / 3.0;

private:
    double thermal_speed_; // sqrt(kT/m)
};

} // namespace clack::reference
