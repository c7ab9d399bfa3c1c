#include "reference/equation_of_state.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace clack::reference {

namespace {

struct Term {
    int exponent;
    double coefficient;
};

// The exponents 8, 10, 14, 22 are not consecutive: with 6..10, as they are often copied, Z is off
// by 5e-4.
constexpr std::array<Term, 12> modified_klm_terms{{{0, 1},
                                                   {1, 4},
                                                   {2, 6},
                                                   {3, 2.3647684},
                                                   {4, -0.8698551},
                                                   {5, 1.1062803},
                                                   {6, -1.1014221},
                                                   {7, 0.66605866},
                                                   {8, -0.03633431},
                                                   {10, -0.20965164},
                                                   {14, 0.10555569},
                                                   {22, -0.00872380}}};

constexpr double packing_fraction_max = 0.54; // number density 1.03, where the fitted data end

/// A function of x and its first two derivatives.
struct Taylor {
    double value = 0, first = 0, second = 0;
};

Taylor modified_klm_of_x(double const x) {
    Taylor sum;
    for (auto const& [k, coefficient] : modified_klm_terms) {
        sum.value += coefficient * std::pow(x, k);
        if (k >= 1) sum.first += coefficient * k * std::pow(x, k - 1);
        if (k >= 2) sum.second += coefficient * k * (k - 1) * std::pow(x, k - 2);
    }
    return sum;
}

void require_fitted_range(double const packing_fraction) {
    if (!(packing_fraction >= 0 && packing_fraction <= packing_fraction_max)) {
        throw std::invalid_argument(
            fmt::format("packing_fraction = {}: the fluid's equation of state holds in [0, {}]",
                        packing_fraction, packing_fraction_max));
    }
}

} // namespace

double modified_klm(double const packing_fraction) {
    require_fitted_range(packing_fraction);
    return modified_klm_of_x(packing_fraction / (1 - packing_fraction)).value;
}

Pressure modified_klm_pressure(double const number_density) {
    double const ball_volume = std::numbers::pi / 6;
    double const packing_fraction = number_density * ball_volume;
    require_fitted_range(packing_fraction);

    double const free = 1 - packing_fraction;
    double const x_first = ball_volume / (free * free);
    double const x_second = 2 * ball_volume * ball_volume / (free * free * free);
    Taylor const z = modified_klm_of_x(packing_fraction / free);
    return {number_density * z.value, z.value + number_density * z.first * x_first,
            2 * z.first * x_first +
                number_density * (z.second * x_first * x_first + z.first * x_second)};
}

double schultz_fluid(double const packing_fraction) {
    require_fitted_range(packing_fraction);
    constexpr std::array low{2.094395102393195,     0.5483113556160761,   -0.04333676720888957,
                             0.05751876349502738,   0.07502830097299396,  -0.014474727265714415,
                             -0.003183349327605778, 0.017074836705042406, -0.0026047002163831975,
                             -0.005498931252679095};
    constexpr std::array high{6.960601433965988e-03, -2.263564675011192e-06, 5.464112392968496e-10,
                              -3.004093460638223e-14};
    double const rho = packing_fraction * 6 / std::numbers::pi;
    double power = 1, sum = 0;
    for (double const coefficient : low) sum += coefficient * (power *= rho);
    power *= rho;
    for (double const coefficient : high) {
        sum += coefficient * power;
        power *= std::pow(7123.0875, rho);
    }
    return std::exp(sum);
}

double carnahan_starling(double const packing_fraction) {
    if (!(packing_fraction >= 0 && packing_fraction < 1)) {
        throw std::invalid_argument(
            fmt::format("packing_fraction = {}: must lie in [0, 1)", packing_fraction));
    }
    double const eta = packing_fraction;
    return (1 + eta + eta * eta - eta * eta * eta) / ((1 - eta) * (1 - eta) * (1 - eta));
}

} // namespace clack::reference
