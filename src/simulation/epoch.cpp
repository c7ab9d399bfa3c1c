#include "simulation/epoch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace clack {

double epoch_length(System const& system, double speed) {
    double const eta = std::min(system.packing_fraction(), 0.74);
    // Carnahan and Starling's contact value is near enough.
    double const contact_value = (1 - eta / 2) / ((1 - eta) * (1 - eta) * (1 - eta));
    double const cross_section = std::numbers::pi * system.diameter * system.diameter;
    double const mean_free_path =
        1 / (std::numbers::sqrt2 * system.number_density() * cross_section * contact_value);
    double const way = std::max(std::min(64 * mean_free_path, system.side / 2),
                                std::min(8 * mean_free_path, 4 * system.side));
    // One epoch for all time that a scene at rest may ask for, in float too: epochs in which
    // nothing happens are gone through one by one.
    constexpr double nothing_moves = 0x1p126;
    if (!(speed > 0)) return nothing_moves;
    int exponent = 0;
    std::frexp(way / speed, &exponent);
    return std::ldexp(1.0, exponent);
}

} // namespace clack
