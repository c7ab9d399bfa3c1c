#pragma once
// Pair correlations of the fluid: state points, one measurement, and what it should give.

#include "observables/radial_distribution.hpp"
#include "observables/structure_factor.hpp"
#include "reference/pair_distribution.hpp"
#include "validation/equation_of_state.hpp"
#include "validation/statistics/estimate.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace clack::validation::pair_correlation {

using equation_of_state::StatePoint;

/// A dilute fluid, where the closure of Percus and Yevick is right, a dense and a liquid one.
inline std::vector<StatePoint> state_points(Profile const profile) {
    int const longer = profile == Profile::quick ? 1 : 20;
    return {{{{0.05, 500}, 30, 600.0 * longer}, 1000 * longer},
            {{{0.30, 864}, 50, 300.0 * longer}, 200 * longer},
            {{{0.45, 864}, 200, 300.0 * longer}, 200 * longer}};
}

constexpr int bins_per_diameter = 50;
constexpr int waves = 12; // up to |n|^2 of this
/// Where g is judged: beside contact, on both sides of the first minimum and at the second peak.
/// Bins are so narrow that g hardly bends in them.
constexpr std::array<double, 4> judged_at{1.11, 1.31, 1.61, 2.11};

inline double reach(PeriodicFluid const& fluid) {
    return 1 + std::floor(2 * (std::min(fluid.side() / 2, 4.0) - 1)) / 2; // whole bins
}
inline int bins(PeriodicFluid const& fluid) {
    return static_cast<int>(std::lround((reach(fluid) - 1) * bins_per_diameter));
}

/// What one replicate measures: g at contact, S(k) shell by shell, then g bin by bin.
enum Value : std::size_t { contact, shells };

inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(point.scene(seed));
    System const& system = engine->system();
    auto const fit = equation_of_state::contact_fit(point.packing_fraction);
    RadialDistribution near(system, fit.reach, 40);
    RadialDistribution far(system, reach(point), bins(point));
    StructureFactor wave(system, waves);
    run_periodic(point, *engine, {point.looks, [&](Snapshot const& shot) {
                                      near.add(shot);
                                      far.add(shot);
                                      wave.add(shot);
                                  }});
    Measurement values{extrapolated(near.distances(), near.values(), 1, fit.degree)};
    for (double const s : wave.values()) values.push_back(s);
    for (double const g : far.values()) values.push_back(g);
    return values;
}

/// The wave numbers of a point's shells.
inline std::vector<double> wave_numbers(StatePoint const& point) {
    return StructureFactor(point.scene(0).system, waves).wave_numbers();
}

/// S(k) / S(k) by Percus and Yevick hardly depends on k, so its limit for k -> 0 needs no more than
/// a straight line in k^2: the limit is that line's, times the closure's own.
inline double long_wave_limit(StatePoint const& point, Measurement const& replicate) {
    reference::PercusYevick const closure(point.packing_fraction, 1);
    std::vector<double> squares, ratios;
    std::size_t value = shells;
    for (double const k : wave_numbers(point)) {
        squares.push_back(k * k);
        ratios.push_back(replicate[value++] / closure.structure_factor(k));
    }
    return line_through(squares, ratios).at_0 * closure.structure_factor(1e-6);
}

/// g of N balls at contact by the virial theorem: Zc / (4 eta).
inline double contact_theory(PeriodicFluid const& fluid) {
    return fluid.collisional() / (4 * fluid.packing_fraction);
}

/// Contact value: as in equation_of_state, since it is extrapolated. The closure at the dilute
/// point: 1 % of the contact value, several times its own error there. The mended one at the
/// others: 3 %, its own error being some 1 %. Long waves: 6 %, several standard errors. These are
/// four times smaller in the full profile, which leaves room for half of the first margin and a
/// third of the last; the theories get no better.
struct Margins {
    double contact = 1e-2, dilute = 1e-2, mended = 3e-2, waves = 6e-2;
};
constexpr Margins margins(Profile const profile) {
    if (profile == Profile::quick) return {};
    return {.contact = 5e-3, .waves = 2e-2};
}
/// What the theories of g are wrong by, as parts of the contact value.
constexpr double dilute_error = 2e-3, mended_error = 1e-2;

inline void enter_g(Ledger& ledger, StatePoint const& point,
                    std::vector<Measurement> const& replicates, Margins const& margins) {
    double const eta = point.packing_fraction, at_contact = contact_theory(point);
    bool const dilute = eta < 0.1;
    reference::PercusYevick const closure(eta, 3);
    reference::VerletWeis const mended(eta, at_contact, 3);
    std::size_t const first_bin = shells + wave_numbers(point).size();
    for (double const r : judged_at) {
        auto const bin = static_cast<std::size_t>((r - 1) * bins_per_diameter);
        double const theory =
            dilute ? closure.radial_distribution(r) : mended.radial_distribution(r);
        ledger.compare({cell(eta)}, {fmt::format("g({:.2f})", r), fmt::format("$g({:.2f})$", r)},
                       {.measured = mean_of(replicates, first_bin + bin),
                        .reference = theory,
                        .reference_error = (dilute ? dilute_error : mended_error) * at_contact,
                        .margin = (dilute ? margins.dilute : margins.mended) * at_contact});
    }
}

inline void enter(Ledger& ledger, StatePoint const& point,
                  std::vector<Measurement> const& replicates, Margins const& margins) {
    std::vector<std::string> const state{cell(point.packing_fraction)};
    double const at_contact = contact_theory(point);
    ledger.compare(state, {"contact", "$g(\\sigma^+)$"},
                   {.measured = mean_of(replicates, contact),
                    .reference = at_contact,
                    .margin = margins.contact * at_contact});
    double const limit = 1 / reference::modified_klm_pressure(point.number_density()).slope;
    auto const long_waves = [&](Measurement const& m) { return long_wave_limit(point, m); };
    ledger.compare(state, {"long_waves", "$S(k \\to 0)$"},
                   {.measured = mean_of(replicates, long_waves),
                    .reference = limit,
                    .margin = margins.waves * limit});
    enter_g(ledger, point, replicates, margins);
}

} // namespace clack::validation::pair_correlation
