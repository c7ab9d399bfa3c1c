#include "reference/two_balls.hpp"

#include "reference/finite_size.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace clack::reference {

namespace {

void require_unit_interval(double const x) {
    if (!(x >= 0 && x <= 1)) {
        throw std::invalid_argument(
            fmt::format("x = {}: the diameter over the accessible side must lie in [0, 1]", x));
    }
}

/// d ln(1/Q) / d ln(diameter), Q being the volume free to the pair: x p' / (1 - p).
double contact_weight(TwoBalls const& balls) {
    double const x = balls.diameter / balls.accessible_side();
    return x * nearer_density(x) / (1 - nearer_probability(x));
}

} // namespace

double nearer_probability(double const x) {
    require_unit_interval(x);
    return x * x * x *
           (4 * std::numbers::pi / 3 + x * (-3 * std::numbers::pi / 2 + x * (1.6 - x / 6)));
}

double nearer_density(double const x) {
    require_unit_interval(x);
    return x * x * (4 * std::numbers::pi + x * (-6 * std::numbers::pi + x * (8 - x)));
}

double TwoBalls::wall_force() const {
    return temperature() / accessible_side() * (2 + contact_weight(*this) / 3);
}

double TwoBalls::wall_pressure() const {
    return wall_force() / (accessible_side() * accessible_side());
}

double TwoBalls::collision_rate() const {
    constexpr double degrees_of_freedom = 6;
    return contact_weight(*this) * energy_shell_factor(degrees_of_freedom) *
           std::numbers::inv_sqrtpi * std::sqrt(temperature() / mass) / diameter;
}

} // namespace clack::reference
