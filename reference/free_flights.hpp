#pragma once
// How long a ball of a dilute gas flies between two collisions. Fast balls collide more often than
// slow ones, so neither are the times exponential nor the numbers of collisions Poisson's.

namespace clack::reference {

/// Free times and paths in the limit of density zero, where the partners that a ball meets are
/// drawn from Maxwell's law afresh each time. Times are in mean free times, lengths in mean free
/// paths. By quadrature, right to 1e-9.
/// Source: P. Visco, F. van Wijland, E. Trizac, J. Phys. Chem. B 112, 5412 (2008),
/// arXiv:0801.2728.
namespace free_flights {

/// Collisions per unit time of a ball with this speed, over the mean of all balls.
///   speed   in sqrt(kT/m)
double relative_rate(double speed);

double time_density(double time);           // of the time between two collisions of a ball
double time_survival(double time);          // no collision for so long from a random instant on
double time_moment(int power);              // <t^power> / <t>^power
double length_moment(int power);            // <l^power> / <l>^power
constexpr double exponential[]{1, 1, 2, 6}; // the same moments of the law that it is not

} // namespace free_flights

} // namespace clack::reference
