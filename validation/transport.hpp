#pragma once
// Momentum and heat carried through a fluid: shared by viscosity and thermal_conductivity.

#include "observables/helfand_moments.hpp"
#include "reference/enskog.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/harness/options.hpp"
#include "validation/periodic_fluid.hpp"

#include <fmt/format.h>

namespace clack::validation::transport {

/// Where, and between which times Helfand's moments are taken to grow straight.
struct StatePoint {
    PeriodicFluid fluid;
    double from, to;   // mean free times
    double production; // the same, of one replicate
    int replicates = 16;

    std::string text() const {
        return fmt::format("{} from={} to={} production={}", fluid.text(), from, to, production);
    }
};

/// Where Enskog's theory is a yardstick: what it leaves out is of the order of the packing fraction
/// squared.
constexpr double yardstick_max = 0.02, bulk_yardstick_max = 0.06;

/// Few balls: the moments are of the whole fluid, so that more of them tell no more, and the
/// coefficients hardly depend on their number.
inline std::vector<StatePoint> state_points(Profile const profile) {
    double const longer = profile == Profile::quick ? 1 : 20;
    return {{{0.01, 108}, 8, 16, 8000 * longer},
            {{0.05, 108}, 8, 16, 6000 * longer},
            {{0.2, 108}, 8, 16, 2000 * longer},
            {{0.35, 108}, 10, 20, 2000 * longer},
            {{0.49, 108}, 40, 80, 3000 * longer}};
}

enum Value : std::size_t { shear_viscosity, bulk_viscosity, thermal_conductivity };

/// Mean squares of the moments' increments over one lag. Traceless part and pressure are told
/// apart; the mean pressure is taken off.
struct Increments {
    double shear = 0, pressure = 0, heat = 0;
};

inline Increments increments(std::vector<Eigen::Matrix3d> const& stress,
                             std::vector<Eigen::Vector3d> const& heat, std::size_t const lag) {
    double const mean = (stress.back() - stress.front()).trace() / 3 /
                        static_cast<double>(stress.size() - 1) * static_cast<double>(lag);
    Increments squares;
    auto const origins = static_cast<double>(stress.size() - lag);
    for (std::size_t k = 0; k + lag < stress.size(); ++k) {
        Eigen::Matrix3d const step = stress[k + lag] - stress[k];
        double const third = step.trace() / 3;
        Eigen::Matrix3d const traceless = step - third * Eigen::Matrix3d::Identity();
        squares.shear += traceless.squaredNorm() / origins;
        squares.pressure += (third - mean) * (third - mean) / origins;
        squares.heat += (heat[k + lag] - heat[k]).squaredNorm() / origins;
    }
    return squares;
}

/// The three coefficients, from how much the mean squares grow between the two times.
inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    constexpr double equilibration = 50; // collisions per ball
    constexpr std::size_t looks = 8;     // up to the first of the two times
    auto const engine = point.fluid.start(seed, equilibration, make);
    HelfandMoments moments(engine->system(), engine->snapshot());
    double const interval = point.from / looks / point.fluid.collision_rate();
    std::vector<Eigen::Matrix3d> stress;
    std::vector<Eigen::Vector3d> heat;
    auto const last = std::lround(point.production / point.from * looks);
    for (long look = 0; look <= last; ++look) {
        double const time = static_cast<double>(look) * interval;
        engine->advance({.time = time}, &moments);
        stress.push_back(moments.stress(time));
        heat.push_back(moments.heat(time));
    }
    auto const far = static_cast<std::size_t>(std::lround(looks * point.to / point.from));
    Increments const early = increments(stress, heat, looks), late = increments(stress, heat, far);
    // kT = 1. A traceless tensor has ten times the mean square of one component off its diagonal.
    double const unit = 2 * point.fluid.volume() * static_cast<double>(far - looks) * interval;
    return {(late.shear - early.shear) / (10 * unit), (late.pressure - early.pressure) / unit,
            (late.heat - early.heat) / (3 * unit)};
}

inline double enskog(StatePoint const& point, Value const value) {
    reference::Enskog const theory(point.fluid.packing_fraction);
    return value == shear_viscosity  ? theory.shear_viscosity
           : value == bulk_viscosity ? theory.bulk_viscosity
                                     : theory.thermal_conductivity;
}

/// Over Enskog's value.
inline Estimate over_enskog(StatePoint const& point, std::vector<Measurement> const& seen,
                            Value const value) {
    double const unit = enskog(point, value);
    Estimate const found = mean_of(seen, value);
    return {found.value / unit, found.error / unit, found.degrees_of_freedom};
}

/// A yardstick up to a packing fraction, beyond it a guide line.
inline void enter(Ledger& ledger, StatePoint const& point, std::vector<Measurement> const& seen,
                  Value const value, Quantity const& quantity, double const margin,
                  double const packing_fraction_max = yardstick_max) {
    std::vector<std::string> const state{cell(point.fluid.packing_fraction),
                                         cell(point.fluid.count)};
    Comparison const found{{}, over_enskog(point, seen, value), 1, 0, margin};
    point.fluid.packing_fraction <= packing_fraction_max ? ledger.compare(state, quantity, found)
                                                         : ledger.guide(state, quantity, found);
}

} // namespace clack::validation::transport
