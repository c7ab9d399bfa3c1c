#pragma once
// Momentum and heat carried through a fluid: state points, one measurement, and what it should
// give.

#include "observables/helfand_moments.hpp"
#include "reference/enskog.hpp"
#include "validation/harness/ledger.hpp"
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

/// The highest packing fraction where Enskog's theory is a yardstick.
constexpr double judged_up_to = 0.1;

/// Few balls: the moments are of the whole fluid, so that more of them tell no more, and what fewer
/// of them take off the coefficients is known.
inline std::vector<StatePoint> state_points(Profile const profile) {
    double const longer = profile == Profile::quick ? 1 : 20;
    return {{{0.01, 108}, 8, 16, 8000 * longer},
            {{0.05, 108}, 8, 16, 6000 * longer},
            {{judged_up_to, 108}, 8, 16, 6000 * longer, 24},
            {{0.2, 108}, 8, 16, 1000 * longer},
            {{0.35, 108}, 10, 20, 1000 * longer},
            {{0.49, 108}, 40, 80, 2000 * longer}};
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

/// What is asked of one coefficient.
struct Asked {
    Value value;
    Quantity quantity;
    double margin;                          // as a part of Enskog's value
    double lowest, highest;                 // packing fractions where that is a yardstick
    double reference::Enskog::*coefficient; // the yardstick
    double (*of_count)(double);             // what so few balls have of it
};

/// Enskog leaves out what is of the order of the packing fraction squared. The margins of the shear
/// viscosity and of the conductivity are a quarter and a sixth of what collisions add to
/// Boltzmann's value where they are judged last. The bulk viscosity is all due to collisions; in
/// the thinnest gas it is all noise.
inline std::vector<Asked> const asked{{shear_viscosity,
                                       {"shear", "$\\eta_{\\mathrm s}$ / Enskog's"},
                                       0.05,
                                       0,
                                       judged_up_to,
                                       &reference::Enskog::shear_viscosity,
                                       reference::momentum_flux_of},
                                      {bulk_viscosity,
                                       {"bulk", "$\\zeta$ / Enskog's"},
                                       0.15,
                                       0.02,
                                       0.06,
                                       &reference::Enskog::bulk_viscosity,
                                       [](double) { return 1.0; }},
                                      {thermal_conductivity,
                                       {"conductivity", "$\\lambda$ / Enskog's"},
                                       0.08,
                                       0,
                                       judged_up_to,
                                       &reference::Enskog::thermal_conductivity,
                                       reference::heat_flux_of}};

inline Estimate over_enskog(StatePoint const& point, std::vector<Measurement> const& seen,
                            Asked const& of) {
    double const unit = reference::Enskog(point.fluid.packing_fraction).*of.coefficient *
                        of.of_count(static_cast<double>(point.fluid.count));
    return mean_of(seen, [&](Measurement const& values) { return values[of.value] / unit; });
}

/// Boltzmann's value, of a gas without density, over Enskog's.
inline double boltzmann_over_enskog(Asked const& of) {
    constexpr double no_density = 1e-9;
    return reference::Enskog(no_density).*of.coefficient /
           reference::Enskog(judged_up_to).*of.coefficient;
}

/// A yardstick up to a packing fraction, where Boltzmann's value must not pass; beyond it a guide.
inline void enter(Ledger& ledger, StatePoint const& point, std::vector<Measurement> const& seen) {
    double const eta = point.fluid.packing_fraction;
    std::vector<std::string> const state{cell(eta), cell(point.fluid.count)};
    for (Asked const& of : asked) {
        if (eta < of.lowest) continue;
        Comparison found{
            .measured = over_enskog(point, seen, of), .reference = 1, .margin = of.margin};
        if (eta > of.highest) {
            ledger.guide(state, of.quantity, found);
            continue;
        }
        ledger.compare(state, of.quantity, found);
        if (eta != judged_up_to) continue;
        found.reference = boltzmann_over_enskog(of);
        found.asks = Asks::whether_apart;
        ledger.compare(state, {of.quantity.name + "_not_boltzmann", of.quantity.symbol}, found);
    }
}

} // namespace clack::validation::transport
