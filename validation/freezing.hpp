#pragma once
// Fluid and crystal about their coexistence: state points, one measurement, and where they meet.

#include "observables/bond_order.hpp"
#include "observables/radial_distribution.hpp"
#include "validation/crystal.hpp"
#include "validation/harness/findings.hpp"
#include "validation/periodic_run.hpp"

#include <Eigen/QR>

#include <cmath>
#include <vector>

namespace clack::validation::freezing {

constexpr int replicates = 12;

/// Both branches, within and a little beyond the densities at which they are stable (0.939 for the
/// fluid, 1.038 for the crystal), where neither turns into the other in so short a run.
struct Branches {
    std::vector<PeriodicRun> fluid, crystal;
};

inline Branches branches(Profile const profile) {
    double const production = profile == Profile::quick ? 900 : 20'000;
    auto const run = [&](double const rho, Arrangement const start) {
        return PeriodicRun{rho * std::numbers::pi / 6, 500, 200, production, start};
    };
    Branches both;
    for (double const rho : {0.86, 0.89, 0.92, 0.95})
        both.fluid.push_back(run(rho, Arrangement::random));
    for (double const rho : {1.02, 1.04, 1.06, 1.08})
        both.crystal.push_back(run(rho, Arrangement::fcc));
    return both;
}

/// A start at random where the crystal is the stable phase.
inline PeriodicRun forced_fluid() { return {0.56, 500, 100, 100, Arrangement::random}; }

/// What one replicate measures: the compressibility factor of N balls and, of the last instant, the
/// bond order.
enum Value : std::size_t { by_virial, by_rate, order };

inline Measurement measure(PeriodicRun const& run, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(run.scene(seed));
    auto const twice = run_periodic(run, *engine);
    return {twice.by_virial, twice.by_rate,
            bond_order(engine->system(), engine->snapshot(), crystal::bond_reach(run))};
}

/// Theory's Z of the run's N balls.
inline double theory_of(PeriodicRun const& run) {
    return run.arrangement == Arrangement::fcc
               ? reference::periodic_crystal(run.packing_fraction, run.count)
               : reference::periodic_compressibility(run.number_density(), run.count);
}

/// The pressure of infinitely many balls along a branch: theory's, times a straight line in the
/// density through what was measured over what theory expected of N balls.
class Branch {
public:
    /// `compressibilities`: of one replicate of each run.
    Branch(std::vector<PeriodicRun> const& runs, std::vector<double> const& compressibilities)
        : crystal_(runs.front().arrangement == Arrangement::fcc) {
        std::vector<double> densities, ratios;
        for (std::size_t k = 0; k < runs.size(); ++k) {
            densities.push_back(runs[k].number_density());
            ratios.push_back(compressibilities[k] / theory_of(runs[k]));
        }
        anchor_ = crystal_ ? reference::crystal_free_energy_density : densities.front();
        at_anchor_ = extrapolated(densities, ratios, anchor_, 1);
        slope_ = extrapolated(densities, ratios, anchor_ + 1, 1) - at_anchor_;
    }

    double compressibility(double const rho) const {
        double const eta = rho * std::numbers::pi / 6;
        double const theory =
            crystal_ ? reference::schultz_crystal(eta) : reference::modified_klm(eta);
        return theory * (at_anchor_ + slope_ * (rho - anchor_));
    }

    /// Density at a pressure, by bisection between the branch's ends.
    double density(double const pressure) const {
        double low = crystal_ ? 1.0 : 0.8, high = crystal_ ? 1.15 : 1.0;
        constexpr int halvings = 50;
        for (int k = 0; k < halvings; ++k) {
            double const middle = (low + high) / 2;
            (middle * compressibility(middle) < pressure ? low : high) = middle;
        }
        return low;
    }

    /// mu / kT less the logarithm of the cube of the thermal wave length: ln rho + A_ex / NkT + Z.
    /// A_ex is known at the anchor (for the fluid: from theory up to the branch's first run) and
    /// follows from there by integrating what was measured.
    double chemical_potential(double const pressure) const {
        double const rho = density(pressure);
        double const from = crystal_ ? reference::crystal_free_energy : fluid_free_energy(anchor_);
        double const excess =
            from + integral(anchor_, rho, [this](double r) { return compressibility(r); });
        return std::log(rho) - 1 + excess + compressibility(rho);
    }

private:
    /// Integral of (Z - 1) / rho by Simpson's rule.
    template <class Z> static double integral(double const from, double const to, Z const& z) {
        constexpr int steps = 200;
        double const step = (to - from) / steps;
        double sum = 0;
        for (int k = 0; k <= steps; ++k) {
            double const rho = from + k * step;
            double const weight = k == 0 || k == steps ? 1 : k % 2 == 1 ? 4 : 2;
            sum += weight * (z(rho) - 1) / rho;
        }
        return sum * step / 3;
    }
    static double fluid_free_energy(double const rho) {
        constexpr double dilute = 1e-6; // below, (Z - 1) / rho is 2 pi / 3
        return 2 * std::numbers::pi / 3 * dilute + integral(dilute, rho, [](double const r) {
                   return reference::modified_klm(r * std::numbers::pi / 6);
               });
    }

    bool crystal_;
    double anchor_ = 0, at_anchor_ = 1, slope_ = 0;
};

/// Pressure at which the chemical potentials of both branches meet, by bisection.
inline double meeting_pressure(Branch const& fluid, Branch const& solid) {
    double low = 9, high = 14; // the crystal's is the higher one below
    constexpr int halvings = 40;
    for (int k = 0; k < halvings; ++k) {
        double const middle = (low + high) / 2;
        bool const fluid_wins = fluid.chemical_potential(middle) < solid.chemical_potential(middle);
        (fluid_wins ? low : high) = middle;
    }
    return low;
}

/// 0.4 % of Z, about half of what a diameter wrong by 0.1 % does; of the pressure of
/// coexistence 1 %, some twice what that much of Z on the branch of the fluid shifts it by.
constexpr double margin = 4e-3, meeting_margin = 1e-2;
/// Relative error of the theories.
constexpr double theory_error = 6e-4;

inline void add_branch(Findings& findings, PeriodicRun const& run,
                       std::vector<Measurement> const& of_run) {
    bool const solid = run.arrangement == Arrangement::fcc;
    double const expected = theory_of(run);
    findings.add({solid ? "crystal" : "fluid",
                  solid ? "$Z$, crystal" : "$Z$, fluid",
                  run.number_density(),
                  {.measured = mean_of(of_run, by_virial),
                   .reference = expected,
                   .reference_error = theory_error * expected,
                   .margin = margin * expected}});
}

/// Where the branches meet, from each replicate of all runs.
inline Finding meeting(Branches const& both, std::vector<std::vector<Measurement>> const& fluid,
                       std::vector<std::vector<Measurement>> const& solid) {
    auto const replicate_of = [](std::vector<std::vector<Measurement>> const& all, std::size_t k) {
        std::vector<double> values;
        for (auto const& of_run : all) values.push_back(of_run[k][by_virial]);
        return values;
    };
    std::vector<double> pressures;
    for (std::size_t k = 0; k < fluid.front().size(); ++k)
        pressures.push_back(meeting_pressure(Branch(both.fluid, replicate_of(fluid, k)),
                                             Branch(both.crystal, replicate_of(solid, k))));
    return {"coexistence",
            "$p$ of coexistence",
            reference::coexistence_pressure,
            {.measured = mean_of(pressures),
             .reference = reference::coexistence_pressure,
             .reference_error = reference::coexistence_pressure_error,
             .margin = meeting_margin * reference::coexistence_pressure}};
}

/// A fluid forced to where the crystal is stable beside that crystal: it must differ, or else what
/// starts as one phase would pass for the other.
inline Comparison pretence(std::vector<Measurement> const& forced) {
    double const expected =
        reference::periodic_crystal(forced_fluid().packing_fraction, forced_fluid().count);
    return {.name = "fluid at 0.56",
            .measured = mean_of(forced, by_virial),
            .reference = expected,
            .reference_error = theory_error * expected,
            .margin = margin * expected};
}

} // namespace clack::validation::freezing
