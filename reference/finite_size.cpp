#include "reference/finite_size.hpp"

#include "reference/equation_of_state.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace clack::reference {

double collisional_compressibility(double const number_density, std::int64_t const count) {
    if (count < 2)
        throw std::invalid_argument(fmt::format("count = {}: a collision takes two balls", count));
    Pressure const pressure = modified_klm_pressure(number_density);
    double const compressibility = modified_klm(number_density * std::numbers::pi / 6);
    return compressibility - 1 -
           number_density / (2 * static_cast<double>(count)) * pressure.curvature / pressure.slope;
}

double periodic_compressibility(double const number_density, std::int64_t const count) {
    return 1 - 1 / static_cast<double>(count) + collisional_compressibility(number_density, count);
}

double energy_shell_factor(double const degrees_of_freedom) {
    if (!(degrees_of_freedom > 0)) {
        throw std::invalid_argument(
            fmt::format("degrees_of_freedom = {}: must be positive", degrees_of_freedom));
    }
    // The ratio itself: a difference of two logarithms would lose digits as D grows.
    return std::sqrt(degrees_of_freedom / 2) *
           boost::math::tgamma_delta_ratio(degrees_of_freedom / 2, 0.5);
}

double collision_rate(double const collisional, double const degrees_of_freedom) {
    return 6 * std::numbers::inv_sqrtpi * collisional * energy_shell_factor(degrees_of_freedom);
}

double collisional_from_rate(double const rate, double const degrees_of_freedom) {
    return rate / (6 * std::numbers::inv_sqrtpi * energy_shell_factor(degrees_of_freedom));
}

} // namespace clack::reference
