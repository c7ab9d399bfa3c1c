#include "reference/walled_fluid.hpp"

#include "reference/equation_of_state.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace clack::reference {

namespace {

using std::numbers::pi;

double tension(double density) {
    double const eta = pi * density / 6;
    return -9 / (2 * pi) * eta * eta * (1 + eta) / std::pow(1 - eta, 3);
}

/// Balls that a unit of a wall's area holds beyond the bulk's: -(dgamma/drho) / (dmu/drho), with
/// dmu/drho = (dP/drho) / rho.
double adsorption(double density) {
    double const eta = pi * density / 6;
    double const derivative = (2 * eta + 3 * eta * eta) / std::pow(1 - eta, 3) +
                              3 * eta * eta * (1 + eta) / std::pow(1 - eta, 4);
    double const tension_slope = -9 / (2 * pi) * derivative * pi / 6;
    return -tension_slope * density / modified_klm_pressure(density).slope;
}

double balls_in(double accessible, double density) {
    return density * accessible * accessible * accessible +
           6 * accessible * accessible * adsorption(density);
}

} // namespace

double walled_compressibility(double side, double count) {
    constexpr double side_min = 5;
    if (!(side >= side_min) || !(count >= 2))
        throw std::invalid_argument("walled_compressibility: side or count too small");
    double const accessible = side - 1;
    double const volume = accessible * accessible * accessible;
    // The number of balls rises with the density of the bulk: bisection.
    double low = 0, high = 0.54 * 6 / pi; // modified_klm's range
    if (balls_in(accessible, high) < count)
        throw std::invalid_argument("walled_compressibility: denser than a fluid");
    constexpr int halvings = 60;
    for (int k = 0; k < halvings; ++k) {
        double const middle = (low + high) / 2;
        (balls_in(accessible, middle) < count ? low : high) = middle;
    }
    double const pressure = modified_klm_pressure(low).value - 4 * tension(low) / accessible;
    return pressure * volume / count;
}

} // namespace clack::reference
