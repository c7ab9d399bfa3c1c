#pragma once
// Until when the positions of a run can be believed, by the measured growth of errors.

#include "observables/horizon.hpp"
#include "reference/lyapunov_exponent.hpp"
#include "simulation/engine.hpp"
#include "state/real.hpp"
#include "state/system.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace clack::reference {

/// Collisions of one ball with others in unit time as Enskog has it, with Carnahan and Starling's
/// contact value; good to a few per cent in the periodic fluid and the dilute cube, to a fifth in a
/// small dense one, a guide elsewhere. Between walls the centres
/// have less room, and gather at the walls: a layer Gamma = (pi / 4) rho^2 / (1 + rho), exact where
/// dilute and within 4 % of the measured one up to freezing. There they can be hit from one side
/// only: where dilute, 1 / (2 l) of all collisions is missed for each axis.
///   kt  [energy]
inline double rough_collision_rate(System const& system, double const kt) {
    if (system.count < 2) return 0;
    double const room = std::pow(system.accessible_side() / system.diameter, 3);
    double const faces = 6 * room * system.diameter / system.accessible_side();
    auto const others = static_cast<double>(system.count - 1);
    double density = others / room;
    if (system.boundary == Boundary::walls) {
        constexpr int rounds = 8; // each mends most of what the one before left
        for (int round = 0; round < rounds; ++round) {
            double const layer = std::numbers::pi / 4 * density / (1 + density);
            density = others / (room + faces * layer);
        }
    }
    double const eta = std::min(density * std::numbers::pi / 6, 0.74);
    double const contact_value = (1 - eta / 2) / ((1 - eta) * (1 - eta) * (1 - eta));
    double const rate = 4 * std::sqrt(std::numbers::pi * kt / system.mass) / system.diameter *
                        density * contact_value;
    if (system.boundary == Boundary::periodic) return rate;
    double const missed = std::min(system.diameter / (2 * system.accessible_side()), 0.5);
    return rate * std::pow(1 - missed, 3);
}

inline double rounding_unit(Precision const precision) {
    switch (precision) {
    case Precision::single_:
        return static_cast<double>(unit_roundoff<float>);
    case Precision::double_:
        return unit_roundoff<double>;
    case Precision::extended:
        return static_cast<double>(unit_roundoff<long double>);
    default:
        return static_cast<double>(unit_roundoff<quad>);
    }
}

/// An error begins as the rounding of a place, one unit of the cube's side, and grows by the
/// Lyapunov exponent; a factor of a hundred is left for the luck of a run, whose growth fluctuates.
/// Runs in quad show the median of the balls' errors to stay below the stated one.
///   collision_rate   of a ball with others  [1 / time]
/// None for fewer balls than the exponent can be told for, or where nothing collides.
inline std::optional<Horizon> horizon(System const& system, Precision const precision,
                                      double const collision_rate) {
    constexpr double error = 0.01, luck = 100;
    constexpr std::int64_t count_min = 20;
    if (system.count < count_min || !(collision_rate > 0)) return std::nullopt;
    double const start = luck * rounding_unit(precision) * system.side / system.diameter;
    double const collisions =
        std::max(std::log(error / start), 0.0) / lyapunov_exponent_per_collision(system);
    return Horizon{error, collisions, collisions / collision_rate};
}

} // namespace clack::reference
