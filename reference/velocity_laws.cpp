#include "reference/velocity_laws.hpp"

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace clack::reference {

namespace {

/// Twice the largest energy that one ball can have, over its mass: the others keep the momentum
/// of a periodic cube at 0.
double top_square_speed(System const& system, double const kinetic_energy) {
    auto const count = static_cast<double>(system.count);
    double const share = system.boundary == Boundary::periodic ? (count - 1) / count : 1;
    return share * 2 * kinetic_energy / system.mass;
}

} // namespace

VelocityLaw::VelocityLaw(System const& system, double const kinetic_energy)
    : degrees_of_freedom_(system.degrees_of_freedom()),
      top_speed_(std::sqrt(top_square_speed(system, kinetic_energy))) {
    std::int64_t const least = system.boundary == Boundary::walls ? 2 : 3;
    if (system.count < least) {
        throw std::invalid_argument(fmt::format(
            "count = {}: the velocity law takes at least {} balls", system.count, least));
    }
    if (!(kinetic_energy > 0)) {
        throw std::invalid_argument(
            fmt::format("kinetic_energy = {}: must be positive", kinetic_energy));
    }
}

double VelocityLaw::speed_density(double const speed) const {
    double const part = speed / top_speed_;
    if (!(part > 0 && part < 1)) return 0;
    return gsl_ran_beta_pdf(part * part, 1.5, (degrees_of_freedom_ - 3) / 2) * 2 * part /
           top_speed_;
}

double VelocityLaw::speed_probability(double const speed) const {
    double const part = speed / top_speed_;
    if (part <= 0) return 0;
    if (part >= 1) return 1;
    return gsl_cdf_beta_P(part * part, 1.5, (degrees_of_freedom_ - 3) / 2);
}

double VelocityLaw::speed_quantile(double const probability) const {
    // GSL's inverse gives up at some probabilities when the balls are many.
    return top_speed_ *
           std::sqrt(boost::math::ibeta_inv(1.5, (degrees_of_freedom_ - 3) / 2, probability));
}

double VelocityLaw::component_density(double const component) const {
    double const part = component / top_speed_;
    if (!(part > -1 && part < 1)) return 0;
    double const n = degrees_of_freedom_;
    double const at_rest =
        std::numbers::inv_sqrtpi / (boost::math::tgamma_delta_ratio((n - 1) / 2, 0.5) * top_speed_);
    return at_rest * std::pow(1 - part * part, (n - 3) / 2);
}

double VelocityLaw::component_probability(double const component) const {
    double const part = component / top_speed_;
    if (part <= -1) return 0;
    if (part >= 1) return 1;
    double const within = gsl_cdf_beta_P(part * part, 0.5, (degrees_of_freedom_ - 1) / 2);
    return part < 0 ? (1 - within) / 2 : (1 + within) / 2;
}

double VelocityLaw::mean_square_speed() const {
    return top_speed_ * top_speed_ * 3 / degrees_of_freedom_; // mean of Beta(3/2, (n-3)/2)
}

double VelocityLaw::fourth_moment_ratio() const {
    return 5.0 / 3.0 * degrees_of_freedom_ / (degrees_of_freedom_ + 2);
}

MaxwellBoltzmann::MaxwellBoltzmann(double const temperature, double const mass)
    : thermal_speed_(std::sqrt(temperature / mass)) {
    if (!(temperature > 0 && mass > 0)) {
        throw std::invalid_argument(
            fmt::format("temperature = {}, mass = {}: must be positive", temperature, mass));
    }
}

double MaxwellBoltzmann::speed_density(double const speed) const {
    if (speed <= 0) return 0;
    double const u = speed / thermal_speed_;
    return std::sqrt(2 / std::numbers::pi) * u * u * std::exp(-u * u / 2) / thermal_speed_;
}

double MaxwellBoltzmann::speed_probability(double const speed) const {
    if (speed <= 0) return 0;
    double const u = speed / thermal_speed_;
    return gsl_cdf_chisq_P(u * u, 3);
}

double MaxwellBoltzmann::component_density(double const component) const {
    return gsl_ran_gaussian_pdf(component, thermal_speed_);
}

double MaxwellBoltzmann::component_probability(double const component) const {
    return gsl_cdf_gaussian_P(component, thermal_speed_);
}

} // namespace clack::reference
