#pragma once
// Equation of state of the fluid: state points, one measurement, and what it should give.

#include "observables/radial_distribution.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/periodic_run.hpp"

#include <algorithm>
#include <vector>

namespace clack::validation::equation_of_state {

/// Where on the equation of state, and how long.
struct StatePoint : PeriodicRun {
    int looks; // at the pairs that nearly touch, in one replicate

    std::string text() const { return fmt::format("{} looks={}", PeriodicRun::text(), looks); }
};

/// The 95 % error of Z, relative to it, that the full profile is for: that of the best published
/// table, at the number densities that this covers; at others twice as much.
constexpr double aimed_error(double const number_density) {
    return number_density > 0.15 && number_density < 0.91 ? 4e-5 : 8e-5;
}

/// A difference that would not matter, as a part of Zc, the collisional part of Z.
/// A diameter wrong by 0.1 % changes Zc by 0.3 % where it changes it least, in the dilute gas, and
/// by 1.1 % at freezing; the margin is two thirds, and in the full profile one third, of that least
/// effect. What the finite-size law leaves out stays below it at these numbers of balls.
constexpr double margin(Profile const profile) { return profile == Profile::quick ? 2e-3 : 1e-3; }

/// Collisions that the full profile takes. The rate's 95 % error of Z, relative to it, times the
/// root of their number is 0.39 at packing fraction 0.05, 1.2 at 0.20, 2.3 at 0.40 and 2.9 at 0.45
/// in the quick profile; a tenth more, since it is an estimate from finitely many replicates. In a
/// dilute gas Zc is the small part of Z that is judged: the virial's standard error of it, relative
/// to it, times that root is 1.25, and the margin is to be five standard errors.
inline double collisions_needed(double const packing_fraction) {
    double const density = packing_fraction * 6 / std::numbers::pi;
    double const for_the_aim = (0.05 + 6.6 * packing_fraction) / aimed_error(density);
    double const for_the_verdict = 5 * 1.25 / margin(Profile::full);
    return std::pow(std::max(for_the_aim, for_the_verdict), 2);
}

/// The fluid from dilute to just below freezing (packing fraction 0.492). Few balls where that is
/// safe: there the 1/N terms are large enough to be tested too.
inline std::vector<StatePoint> state_points(Profile const profile) {
    if (profile == Profile::quick) {
        // So long that the margin is five standard errors: too few leave a point undecided.
        return {{{{0.01, 108}, 30, 12'000}, 12'000}, {{{0.05, 500}, 30, 1'600}, 1000},
                {{{0.10, 108}, 30, 14'000}, 2000},   {{{0.15, 500}, 30, 1'600}, 1000},
                {{{0.20, 108}, 30, 10'000}, 2000},   {{{0.30, 500}, 50, 2'000}, 300},
                {{{0.40, 500}, 100, 2'500}, 300},    {{{0.45, 864}, 200, 1'800}, 300},
                {{{0.49, 864}, 300, 2'000}, 300}};
    }
    std::vector<StatePoint> points;
    constexpr std::int64_t balls_looked_at = 5'000'000; // in all looks of a replicate
    for (double const density : {0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.935}) {
        double const eta = density * std::numbers::pi / 6;
        // Beyond the 1/N term 864 balls have 1.4(3)e-4 of Zc at density 0.9, and 4000 -0.2(5)e-4.
        // So many replicates that their scatter says the error well.
        PeriodicRun run{{eta, density < 0.75 ? 864 : 4000}, 500, 1, 64};
        run.production = std::ceil(collisions_needed(eta) / run.collisions(64));
        points.push_back({run, static_cast<int>(balls_looked_at / run.count)});
    }
    return points;
}

/// The same for the contact value, which is extrapolated from few pairs: four times as much error
/// as that of the pairs' number.
constexpr double contact_margin(Profile const profile) { return 5 * margin(profile); }

/// Relative error of the theory's Zc. That of a dilute fluid is the virial series', to all digits.
constexpr double theory_error = 2e-5;

/// What one replicate measures: the compressibility factor of N balls, in three ways, and the
/// standard error of the first from this replicate alone, by blocking.
enum Value : std::size_t { by_virial, by_rate, by_contact, blocked_error };

/// How far beyond contact pairs are counted, and by a polynomial of which degree g is extrapolated:
/// as far as it describes a fluid's g to 1e-3. A dilute one has few pairs there, but a straighter
/// g.
struct ContactFit {
    double reach;
    int degree;
};
constexpr ContactFit contact_fit(double const packing_fraction) {
    return packing_fraction < 0.12 ? ContactFit{1.5, 2} : ContactFit{1.15, 3};
}

/// From the virial and the rate of the collisions, and from g at contact, to which snapshots are
/// extrapolated: Zc = 4 eta g(1), exactly, for N balls too.
inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(point.scene(seed));
    double const eta = point.packing_fraction;
    constexpr int bins = 40;
    ContactFit const fit = contact_fit(eta);
    RadialDistribution g(engine->system(), fit.reach, bins);
    auto const twice =
        run_periodic(point, *engine, {point.looks, [&](Snapshot const& shot) { g.add(shot); }});
    double const contact = extrapolated(g.distances(), g.values(), 1, fit.degree);
    return {twice.by_virial, twice.by_rate,
            1 - 1 / static_cast<double>(point.count) + 4 * eta * contact, twice.virial_error};
}

/// Standard error of the mean over all replicates, from what blocking says of each.
inline double error_by_blocking(std::vector<Measurement> const& replicates) {
    double squares = 0;
    for (Measurement const& measurement : replicates)
        squares += measurement[blocked_error] * measurement[blocked_error];
    return std::sqrt(squares) / static_cast<double>(replicates.size());
}

/// One of the values of all replicates beside the theory's.
inline Comparison compare(StatePoint const& point, std::vector<Measurement> const& replicates,
                          Value const value, Profile const profile) {
    double const relative = value == by_contact ? contact_margin(profile) : margin(profile);
    return {.measured = mean_of(replicates, value),
            .reference = point.expected(),
            .reference_error = theory_error * point.collisional(),
            .margin = relative * point.collisional()};
}

/// One route beside another of the same runs, which no theory enters.
inline Comparison difference(std::vector<Measurement> const& replicates, Value const value,
                             double const margin) {
    auto const beyond_virial = [=](Measurement const& m) { return m[value] - m[by_virial]; };
    return {.measured = mean_of(replicates, beyond_virial), .margin = margin};
}

constexpr std::size_t kinds = 6; // of comparisons at a point

/// All that is judged at a point.
inline void enter(Ledger& ledger, StatePoint const& point,
                  std::vector<Measurement> const& replicates, Profile const profile) {
    double const eta = point.packing_fraction;
    std::vector<std::string> const state{cell(eta)};
    Comparison const virial = compare(point, replicates, by_virial, profile);
    Comparison const contact = compare(point, replicates, by_contact, profile);
    Comparison schultz = virial;
    schultz.reference += reference::schultz_fluid(eta) - reference::modified_klm(eta);
    ledger.compare(state, {"virial", "$Z$, virial"}, virial);
    ledger.compare(state, {"rate", "$Z$, rate"}, compare(point, replicates, by_rate, profile));
    ledger.compare(state, {"contact", "$Z$, contact"}, contact);
    ledger.compare(state, {"virial_schultz", "$Z$, virial, Schultz"}, schultz);
    ledger.compare(state, {"rate_minus_virial", "$Z$, rate $-$ virial"},
                   difference(replicates, by_rate, virial.margin));
    ledger.compare(state, {"contact_minus_virial", "$Z$, contact $-$ virial"},
                   difference(replicates, by_contact, contact.margin));
}

/// Compressibility factor by the rate of collisions. The virial adds to it how the speeds at
/// contact scatter, which know nothing of how many contacts there are: 1.3 times the variance.
inline Estimate by_rate_at(std::size_t const k, Ledger const& ledger) {
    return ledger.entries()[kinds * k + 1].comparison.measured;
}

/// That of infinitely many balls: the theory's difference between these and N is taken off.
inline Estimate infinite(StatePoint const& point, Estimate const& z) {
    return {z.value + point.expected_of_infinitely_many() - point.expected(), z.error};
}

} // namespace clack::validation::equation_of_state
