#pragma once
// Fluid and crystal about their coexistence: state points, one measurement, and where they meet.

#include "observables/bond_order.hpp"
#include "validation/crystal.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/periodic_run.hpp"
#include "validation/statistics/estimate.hpp"

#include <cmath>
#include <vector>

namespace clack::validation::freezing {

/// Both branches, within and a little beyond the densities at which they are stable (0.939 for the
/// fluid, 1.038 for the crystal), where neither turns into the other in so short a run.
struct Branches {
    std::vector<PeriodicRun> fluid, crystal;
};

inline Branches branches(Profile const profile) {
    double const production = profile == Profile::quick ? 900 : 20'000;
    auto const run = [&](double const rho, Arrangement const start) {
        return PeriodicRun{{rho * std::numbers::pi / 6, 500, start}, 200, production, 12};
    };
    Branches both;
    for (double const rho : {0.86, 0.89, 0.92, 0.95})
        both.fluid.push_back(run(rho, Arrangement::random));
    for (double const rho : {1.02, 1.04, 1.06, 1.08})
        both.crystal.push_back(run(rho, Arrangement::fcc));
    return both;
}

/// A start at random where the crystal is the stable phase.
inline PeriodicRun forced_fluid() { return {{0.56, 500}, 100, 100, 12}; }

/// What one replicate measures: the compressibility factor of N balls and, of the last instant, the
/// bond order.
enum Value : std::size_t { by_virial, order };

inline Measurement measure(PeriodicRun const& run, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(run.scene(seed));
    auto const twice = run_periodic(run, *engine);
    return {twice.by_virial,
            bond_order(engine->system(), engine->snapshot(), crystal::bond_reach(run))};
}

/// The pressure of infinitely many balls along a branch: theory's, times a straight line in the
/// density through what was measured over what theory expected of N balls.
class Branch {
public:
    /// `compressibilities`: of one replicate of each run.
    Branch(std::vector<PeriodicRun> const& runs, std::vector<double> const& compressibilities)
        : crystal_(runs.front().is_crystal()) {
        std::vector<double> densities, ratios;
        for (std::size_t k = 0; k < runs.size(); ++k) {
            densities.push_back(runs[k].number_density());
            ratios.push_back(compressibilities[k] / runs[k].expected());
        }
        anchor_ = crystal_ ? reference::crystal_free_energy_density : densities.front();
        over_theory_ = line_through(densities, ratios);
    }

    double compressibility(double const rho) const {
        double const eta = rho * std::numbers::pi / 6;
        double const theory =
            crystal_ ? reference::schultz_crystal(eta) : reference::modified_klm(eta);
        return theory * (over_theory_.at_0 + over_theory_.slope * rho);
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
    double anchor_ = 0;
    StraightLine over_theory_;
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

/// Z beside what theory expects.
inline Comparison beside(double const expected, std::vector<Measurement> const& of_run,
                         Asks const asks) {
    return {.measured = mean_of(of_run, by_virial),
            .reference = expected,
            .reference_error = theory_error * expected,
            .margin = margin * expected,
            .asks = asks};
}

inline void enter(Ledger& ledger, PeriodicRun const& run, std::vector<Measurement> const& of_run) {
    Quantity const quantity =
        run.is_crystal() ? Quantity{"crystal", "$Z$, crystal"} : Quantity{"fluid", "$Z$, fluid"};
    ledger.compare({fmt::format("{:g}", run.number_density())}, quantity,
                   beside(run.expected(), of_run, Asks::whether_near));
}

/// Where the branches meet, from each replicate of all runs.
inline Comparison meeting(Branches const& both, std::vector<std::vector<Measurement>> const& fluid,
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
    return {.measured = mean_of(pressures),
            .reference = reference::coexistence_pressure,
            .reference_error = reference::coexistence_pressure_error,
            .margin = meeting_margin * reference::coexistence_pressure};
}

/// A fluid forced to where the crystal is stable beside that crystal: it must differ, or else what
/// starts as one phase would pass for the other.
inline Comparison pretence(std::vector<Measurement> const& forced) {
    PeriodicRun const run = forced_fluid();
    return beside(reference::periodic_crystal(run.packing_fraction, run.count), forced,
                  Asks::whether_apart);
}

} // namespace clack::validation::freezing
