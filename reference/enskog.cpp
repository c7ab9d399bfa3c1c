#include "reference/enskog.hpp"

#include "reference/equation_of_state.hpp"

#include <cmath>
#include <numbers>

namespace clack::reference {

namespace {

constexpr double inv_sqrtpi = std::numbers::inv_sqrtpi;

} // namespace

Enskog::Enskog(double const packing_fraction) {
    double const rho = packing_fraction * 6 / std::numbers::pi;
    double const volume = 4 * packing_fraction; // second virial coefficient times rho
    double const y = modified_klm(packing_fraction) - 1;
    double const contact = y / volume;
    double const dilute_viscosity = 5 * inv_sqrtpi / 16;
    double const dilute_conductivity = 75 * inv_sqrtpi / 64;
    collision_rate = 6 * inv_sqrtpi * y;
    self_diffusion = self_diffusion_all_orders * 3 * inv_sqrtpi / (8 * rho * contact);
    bulk_viscosity = dilute_viscosity * 16 / (5 * std::numbers::pi) * volume * volume * contact;
    shear_viscosity =
        shear_viscosity_all_orders * dilute_viscosity / contact * std::pow(1 + 2 * y / 5, 2) +
        3 * bulk_viscosity / 5;
    thermal_conductivity = thermal_conductivity_all_orders * dilute_conductivity / contact *
                               std::pow(1 + 3 * y / 5, 2) +
                           3 * bulk_viscosity / 2;
}

double momentum_flux_of(double const count) {
    double const freedom = 3 * count - 3;
    return (1 - 1 / count) * freedom / (freedom + 2);
}

double heat_flux_of(double const count) {
    double const freedom = 3 * count - 3;
    return momentum_flux_of(count) * (1 - 2 / count) * freedom / (freedom + 4);
}

double speedy_self_diffusion(double const number_density) {
    double const rho2 = number_density * number_density;
    return 3 * inv_sqrtpi / (8 * number_density) * (1 - number_density / 1.09) *
           (1 + rho2 * (0.4 - 0.83 * rho2));
}

double periodic_diffusion_deficit(double const viscosity, double const number_density,
                                  double const self_diffusion, double const side) {
    double const drag = 6 * std::numbers::pi * (viscosity + number_density * self_diffusion);
    return 2.837297 / (drag * side);
}

double long_time_tail(double const number_density, double const self_diffusion,
                      double const shear_viscosity, double const time) {
    double const spread = self_diffusion + shear_viscosity / number_density;
    return 2 / (3 * number_density) * std::pow(4 * std::numbers::pi * spread * time, -1.5);
}

double long_time_tail_in_box(double const count, double const side, double const self_diffusion,
                             double const kinematic_viscosity, double const time) {
    double const wave = 2 * std::numbers::pi / side;
    double const decay = (self_diffusion + kinematic_viscosity) * time * wave * wave;
    double along = 1; // sum over the waves along one axis
    for (int k = 1; decay * k * k < 40; ++k) along += 2 * std::exp(-decay * k * k);
    return (2 * (along * along * along - 1) - 1) / (3 * count);
}

} // namespace clack::reference
