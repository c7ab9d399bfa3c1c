#pragma once
// The face-centred cubic crystal: state points, one measurement, and what it should give.

#include "observables/bond_order.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/periodic_run.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace clack::validation::crystal {

/// From a crystal that would rather melt (it coexists with the fluid at packing fraction 0.543) to
/// one that has 0.7 % of its volume free.
inline std::vector<PeriodicRun> runs(Profile const profile) {
    double const production = profile == Profile::quick ? 400 : 20'000;
    std::vector<PeriodicRun> runs;
    for (double const eta : {0.52, 0.55, 0.58, 0.62, 0.66, 0.70, 0.72, 0.735})
        runs.push_back({{eta, 500, Arrangement::fcc},
                        100,
                        eta < 0.545 ? 4 * production : production, // scatters there by the most
                        12});
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

/// Where the balls are on the mean, as far as they have been looked at: the lattice without the
/// motion about it, if there is one.
class MeanPlaces {
public:
    explicit MeanPlaces(System const& system) : side_(system.side) {}

    void add(Snapshot const& shot) {
        Eigen::Matrix3Xd const places = shot.positions + side_ * shot.images.cast<double>();
        if (looks_++ == 0) mean_.positions = Eigen::Matrix3Xd::Zero(3, places.cols());
        mean_.positions += places;
    }
    Snapshot snapshot() const {
        Snapshot shot = mean_;
        shot.positions /= looks_;
        shot.positions -= side_ * (shot.positions / side_).array().floor().matrix();
        return shot;
    }

private:
    double side_;
    int looks_ = 0;
    Snapshot mean_;
};

/// What one replicate measures: the compressibility factor of N balls, and the bond order of their
/// mean places.
enum Value : std::size_t { by_virial, by_rate, order };

inline Measurement measure(PeriodicRun const& run, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(run.scene(seed));
    constexpr int looks = 100; // a tenth of the motion is left of the mean
    MeanPlaces places(engine->system());
    auto const twice =
        run_periodic(run, *engine, {looks, [&](Snapshot const& shot) { places.add(shot); }});
    return {twice.by_virial, twice.by_rate,
            bond_order(engine->system(), places.snapshot(), bond_reach(run))};
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
/// Global bond order of this lattice and of those that it must not pass for; a fluid's is near 0.
/// The margin is half of what parts it from the nearest of them. The motion takes up to a quarter
/// off, and as much of it as is left of the mean, squared.
constexpr double fcc_order = 0.574524, bcc_order = 0.510688, hcp_order = 0.484762;
constexpr double order_margin = (fcc_order - bcc_order) / 2, order_error = 2e-3;

inline Comparison beside_fcc(Estimate const& bonds) {
    return {.measured = bonds,
            .reference = fcc_order,
            .reference_error = order_error,
            .margin = order_margin};
}

inline void enter(Ledger& ledger, PeriodicRun const& run, std::vector<Measurement> const& of_run) {
    double const eta = run.packing_fraction, schultz = run.expected();
    double const speedy =
        schultz - reference::schultz_crystal(eta) + reference::speedy_crystal(eta);
    auto const add = [&](Quantity const& quantity, Value const value, double const expected) {
        ledger.compare({cell(eta)}, quantity,
                       {.measured = mean_of(of_run, value),
                        .reference = expected,
                        .reference_error = theory_error(eta) * expected,
                        .margin = margin * expected});
    };
    add({"virial", "$Z$, virial"}, by_virial, schultz);
    add({"rate", "$Z$, rate"}, by_rate, schultz);
    add({"virial_speedy", "$Z$, Speedy"}, by_virial, speedy);
    ledger.compare({cell(eta)}, {"bond_order", "$Q_6$"}, beside_fcc(mean_of(of_run, order)));
}

/// Growth of Z from the last run but one to the last, as a multiple of that of the inverse of the
/// free part: 3 (1 - 1/N) where only so little is free, whatever the equation of state; its other
/// terms change that by 3e-5 there.
inline Comparison divergence(std::vector<PeriodicRun> const& runs,
                             std::vector<std::vector<Measurement>> const& all) {
    std::size_t const last = runs.size() - 1;
    double const near = 1 / free_part(runs[last].packing_fraction);
    double const farther = 1 / free_part(runs[last - 1].packing_fraction);
    std::vector<double> slopes;
    for (std::size_t k = 0; k < all[last].size(); ++k)
        slopes.push_back((all[last][k][by_virial] - all[last - 1][k][by_virial]) /
                         (near - farther));
    double const expected = 3 * (1 - 1 / static_cast<double>(runs[last].count));
    return {
        .measured = mean_of(slopes), .reference = expected, .margin = divergence_margin * expected};
}

} // namespace clack::validation::crystal
