#pragma once
// What each mutant of the engine is put to: one state point of an experiment, with the size and the
// settings of its quick profile.

#include "state/errors.hpp"
#include "validation/conservation.hpp"
#include "validation/equation_of_state.hpp"
#include "validation/mutants/mutants.hpp"
#include "validation/velocity_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace clack::validation::power {

/// What an experiment says of a mutant.
struct Outcome {
    Verdict verdict = Verdict::undecided;
    double z = 0;
};

/// A mutant and the experiment that should catch it. A replicate that a law of the engine stopped
/// measures nothing.
struct Trial {
    std::string mutant, experiment, state_point;
    int replicates;
    Measure measure;
    std::function<Outcome(std::vector<Measurement> const&)> judge;

    std::string text() const { return fmt::format("{}: {}: {}", mutant, experiment, state_point); }
};

/// A run of `conservation`: how much of the bounds of rounding is used up, most of all. Each bound
/// is sixteen standard errors.
inline Trial conserving(Fault const fault, Boundary const boundary, double const packing_fraction) {
    auto const points = conservation::state_points(Profile::quick);
    auto const point = *std::find_if(points.begin(), points.end(), [&](auto const& p) {
        return p.boundary == boundary && p.packing_fraction == packing_fraction;
    });
    auto const measure = [=](std::uint64_t const seed) -> Measurement {
        System const system = point.scene(0).system;
        double used = 0;
        for (auto const& moment : conservation::measure(point, seed, with(fault))) {
            double const drift = conservation::drift_bound(moment.collisions_per_ball);
            used = std::max({used, std::abs(moment.energy_drift) / drift, moment.momentum / drift,
                             moment.deepest_overlap / conservation::overlap_bound(system),
                             moment.wall_distance / conservation::wall_bound(system)});
        }
        return {used};
    };
    auto const judge = [](std::vector<Measurement> const& replicates) -> Outcome {
        double const used = replicates.front().front();
        return {used > 1 ? Verdict::differs : Verdict::agrees, 16 * used};
    };
    return {name_of(fault), "conservation", point.text(), 1, measure, judge};
}

/// What a ledger of one state point says, judged as one of so many points of its experiment.
inline Outcome outcome(Ledger& ledger, std::size_t const points) {
    ledger.judge({.false_alarm = Risks{}.false_alarm / static_cast<double>(points)});
    auto const& all = ledger.entries();
    auto const worst = std::max_element(all.begin(), all.end(), [](Entry const& a, Entry const& b) {
        return a.against < b.against;
    });
    return {ledger.verdict(), worst->z};
}

/// A mutant at the first of an experiment's points that is meant, measured and entered as the
/// experiment does.
///   which     takes a point
///   measure   takes a point and a seed
///   enter     takes a ledger, a point and its replicates
template <class Point, class Which, class MeasurePoint, class Enter>
Trial caught_by(std::string const& mutant, std::string const& experiment,
                std::vector<Point> const& points, Which const& which, MeasurePoint const& measure,
                Enter const& enter) {
    auto const found = std::find_if(points.begin(), points.end(), which);
    if (found == points.end())
        throw std::logic_error(fmt::format("{}: {} has no such state point", mutant, experiment));
    Point const point = *found;
    auto const judge = [=, count = points.size()](std::vector<Measurement> const& replicates) {
        Ledger ledger(std::initializer_list<Key>{}); // it is judged, not written
        enter(ledger, point, replicates);
        return outcome(ledger, count);
    };
    return {mutant,
            experiment,
            point.text(),
            point.replicates,
            [=](std::uint64_t const seed) { return measure(point, seed); },
            judge};
}

/// A point of `equation_of_state`.
inline Trial under_pressure(std::string const& mutant, double const packing_fraction,
                            EngineMaker const& make,
                            std::function<double(double z, double count)> const& misread) {
    using namespace equation_of_state;
    return caught_by(
        mutant, "equation_of_state", state_points(Profile::quick),
        [=](StatePoint const& p) { return p.packing_fraction == packing_fraction; },
        [=](StatePoint const& point, std::uint64_t const seed) {
            Measurement values = equation_of_state::measure(point, seed, make);
            for (double& z : values) z = misread(z, static_cast<double>(point.count));
            return values;
        },
        [](Ledger& ledger, StatePoint const& point, auto const& replicates) {
            enter(ledger, point, replicates, Profile::quick);
        });
}

inline Trial under_pressure(Fault const fault, double const packing_fraction) {
    return under_pressure(name_of(fault), packing_fraction, with(fault),
                          [](double const z, double) { return z; });
}

/// A point of `velocity_distribution`.
inline Trial by_velocities(Fault const fault, std::int64_t const count) {
    using namespace velocity_distribution;
    return caught_by(
        name_of(fault), "velocity_distribution", state_points(Profile::quick),
        [=](StatePoint const& p) { return p.count == count; },
        [=](StatePoint const& point, std::uint64_t const seed) {
            return velocity_distribution::measure(point, seed, with(fault));
        },
        velocity_distribution::enter);
}

/// kT = 2E/(3N) where a periodic cube has 3N - 3 degrees of freedom: the kinetic part of Z becomes
/// 1, and the collisional one larger by N / (N - 1).
inline double with_n_for_n_minus_1(double const z, double const n) {
    return 1 + (z - 1 + 1 / n) * n / (n - 1);
}

inline std::vector<Trial> trials() {
    return {under_pressure(Fault::wider_balls, 0.4),
            conserving(Fault::stronger_impulses, Boundary::periodic, 0.3),
            conserving(Fault::missed_collisions, Boundary::periodic, 0.3),
            conserving(Fault::lost_refresh, Boundary::periodic, 0.05),
            conserving(Fault::stale_images, Boundary::periodic, 0.05),
            conserving(Fault::moved_walls, Boundary::walls, 0.3),
            conserving(Fault::lossy_walls, Boundary::walls, 0.3),
            under_pressure(Fault::earlier_normal, 0.15),
            conserving(Fault::rounded_velocities, Boundary::periodic, 0.3),
            under_pressure("n for n - 1 in the temperature", 0.05, make_true_engine,
                           with_n_for_n_minus_1),
            conserving(Fault::late_collisions, Boundary::periodic, 0.3),
            by_velocities(Fault::layered_start, 32)};
}

} // namespace clack::validation::power
