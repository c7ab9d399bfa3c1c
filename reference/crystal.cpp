#include "reference/crystal.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <stdexcept>

namespace clack::reference {

namespace {

/// The density over that of close packing.
double closeness(double const packing_fraction) {
    constexpr double lowest = 0.52; // below, no crystal lasts
    if (!(packing_fraction >= lowest && packing_fraction < close_packing_fraction())) {
        throw std::invalid_argument(
            fmt::format("packing_fraction = {}: the crystal's equation of state holds in [{}, {})",
                        packing_fraction, lowest, close_packing_fraction()));
    }
    return packing_fraction / close_packing_fraction();
}

} // namespace

double close_packing_fraction() { return std::numbers::pi / (3 * std::numbers::sqrt2); }

double schultz_crystal(double const packing_fraction) {
    constexpr std::array coefficients{-0.4338711486444215, 0.390812049911003,  0.595451683236023,
                                      18.59059648880398,   -288.1675745716088, 3206.943027086472,
                                      -21037.60905875148,  83177.92071175583,  -180636.8017944632,
                                      170205.7910137580};
    double const y = 1 - closeness(packing_fraction);
    double z = 3 / y, power = 1;
    for (double const coefficient : coefficients) {
        z += coefficient * power;
        power *= y;
    }
    return z;
}

double speedy_crystal(double const packing_fraction) {
    constexpr double a = 0.5921, b = 0.7072, c = 0.601;
    double const z = closeness(packing_fraction);
    return 3 / (1 - z) - a * (z - b) / (z - c);
}

double periodic_crystal(double const packing_fraction, std::int64_t const count) {
    double const y = 1 - closeness(packing_fraction);
    return schultz_crystal(packing_fraction) - 3 / (y * static_cast<double>(count));
}

} // namespace clack::reference
