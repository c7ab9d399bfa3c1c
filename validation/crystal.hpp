#pragma once
// The face-centred cubic crystal: state points, one measurement, and what it should give.

#include "observables/bond_order.hpp"
#include "validation/harness/findings.hpp"
#include "validation/periodic_run.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace clack::validation::crystal {

constexpr int replicates = 12;

/// From a crystal that would rather melt (it coexists with the fluid at packing fraction 0.543) to
/// one that has 0.7 % of its volume free.
inline std::vector<PeriodicRun> runs(Profile const profile) {
    double const production = profile == Profile::quick ? 400 : 20'000;
    std::vector<PeriodicRun> runs;
    for (double const eta : {0.52, 0.55, 0.58, 0.62, 0.66, 0.70, 0.72, 0.735})
        runs.push_back({eta, 500, 100, production, Arrangement::fcc});
    return runs;
}

/// Free part of the volume, 1 - density over that of close packing.
inline double free_part(double const packing_fraction) {
    return 1 - packing_fraction / reference::close_packing_fraction();
}

/// Balls nearer than this are bonded: half way between first and second neighbours of the lattice.
inline double bond_reach(PeriodicRun const& run) {
    double const nearest = std::cbrt(std::numbers::sqrt2 / run.number_density());
    return nearest * (1 + std::numbers::sqrt2) / 2;
}

/// What one replicate measures: the compressibility factor of N balls, and the bond order.
enum Value : std::size_t { by_virial, by_rate, order };

inline Measurement measure(PeriodicRun const& run, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(run.scene(seed));
    constexpr int looks = 10;
    double order = 0;
    auto const twice = run_periodic(
        run, *engine, {looks, [&](Snapshot const& shot) {
                           order += bond_order(engine->system(), shot, bond_reach(run)) / looks;
                       }});
    return {twice.by_virial, twice.by_rate, order};
}

/// 0.4 % of Z: four tenths of what a diameter wrong by 0.1 % does where it does least, and room for
/// the terms of order 1/N that periodic_crystal leaves out (0.1 % at 500 balls where the crystal
/// would rather melt). The slope of the divergence: 0.4 %, twice what 1 in the place of 1 - 1/N
/// makes.
constexpr double margin = 4e-3, divergence_margin = 4e-3;
/// Relative error of the theory: 3e-4, but 6e-4 where the crystal would rather melt.
constexpr double theory_error(double const packing_fraction) {
    return packing_fraction < 0.545 ? 6e-4 : 3e-4;
}
/// Global bond order of the lattice without motion; a fluid's is near 0, so half lies between.
constexpr double lattice_order = 0.57452;

inline void add_findings(Findings& findings, PeriodicRun const& run,
                         std::vector<Measurement> const& of_run) {
    double const eta = run.packing_fraction;
    double const schultz = reference::periodic_crystal(eta, run.count);
    double const speedy =
        schultz - reference::schultz_crystal(eta) + reference::speedy_crystal(eta);
    auto const add = [&](char const* name, char const* symbol, Value value, double expected) {
        findings.add({name,
                      symbol,
                      eta,
                      {.measured = mean_of(of_run, value),
                       .reference = expected,
                       .reference_error = theory_error(eta) * expected,
                       .margin = margin * expected}});
    };
    add("virial", "$Z$, virial", by_virial, schultz);
    add("rate", "$Z$, rate", by_rate, schultz);
    add("virial_speedy", "$Z$, Speedy", by_virial, speedy);
    findings.add({"bond_order",
                  "$Q_6$",
                  eta,
                  {.measured = mean_of(of_run, order),
                   .reference = lattice_order,
                   .margin = lattice_order / 2}});
}

/// Growth of Z from the last run but one to the last, as a multiple of that of the inverse of the
/// free part: 3 (1 - 1/N) where only so little is free, whatever the equation of state; its other
/// terms change that by 3e-5 there.
inline Finding divergence(std::vector<PeriodicRun> const& runs,
                          std::vector<std::vector<Measurement>> const& all) {
    std::size_t const last = runs.size() - 1;
    double const near = 1 / free_part(runs[last].packing_fraction);
    double const farther = 1 / free_part(runs[last - 1].packing_fraction);
    std::vector<double> slopes;
    for (std::size_t k = 0; k < all[last].size(); ++k)
        slopes.push_back((all[last][k][by_virial] - all[last - 1][k][by_virial]) /
                         (near - farther));
    double const expected = 3 * (1 - 1 / static_cast<double>(runs[last].count));
    return {"divergence",
            "slope of $Z$ against $1/y$",
            runs[last].packing_fraction,
            {.measured = mean_of(slopes),
             .reference = expected,
             .margin = divergence_margin * expected}};
}

} // namespace clack::validation::crystal
