#pragma once
// Trajectories beside those of soft balls: state points, one measurement, and what it should give.

#include "validation/harness/ledger.hpp"
#include "validation/records/campaign.hpp"
#include "validation/soft_runs.hpp"
#include "validation/statistics/estimate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

namespace clack::validation::trajectories_vs_lammps {

constexpr double steps_per_contact = 100; // a speed then errs by 1e-6 of itself a contact
constexpr double equilibration = 30;      // collisions per ball

/// What all jobs run.
inline std::string deck() { return reference::lammps_deck("lammps_cube.in"); }

/// Balls between walls, and how hard the soft ones are.
struct StatePoint {
    double packing_fraction;
    std::int64_t count;
    double segment_time;
    int segments; // of one replicate, one after the other
    int replicates;
    std::vector<double> stiffnesses; // each four times the one before, for Richardson
    std::size_t first_judged;        // from this on contacts are short beside the time between them

    System system() const {
        double const density = packing_fraction * 6 / std::numbers::pi;
        return {.side = std::cbrt(static_cast<double>(count) / density), .count = count};
    }
    std::string text() const {
        return fmt::format("packing_fraction={} count={} segment_time={} segments={} "
                           "equilibration={} steps_per_contact={} stiffnesses={} deck={:016x}",
                           packing_fraction, count, segment_time, segments, equilibration,
                           steps_per_contact, fmt::join(stiffnesses, ","), hash_of(deck()));
    }
};

/// From a stiffness on at which a contact lasts less than a hundredth of the time between the
/// collisions of a ball, and two softer ones to show the way there; the hardest of all, which take
/// as long as the others together, for the fewest balls. A segment is so short that of ten balls
/// five to eight collide, most of them once: the smaller the cube, the more hit walls. In
/// the shortest ones the fewest balls collide twice, so that the median comes nearest to the lowest
/// that passes: they are the most, so that seeds hardly ever leave them undecided.
inline std::vector<StatePoint> state_points(Profile const profile) {
    bool const full = profile == Profile::full;
    int const replicates = full ? 20 : 6, more = full ? 5 : 1;
    std::vector<StatePoint> points;
    for (auto const& [count, at_02, time_at_02, at_04, time_at_04, hardest] :
         {std::tuple{27, 16, 0.07, 40, 0.0125, 16},
          {100, 5, 0.1, 5, 0.025, 4},
          {1000, 1, 0.1, 1, 0.025, 4}}) {
        for (auto const& [packing_fraction, segments, time, hard] :
             {std::tuple{0.2, at_02, time_at_02, 2.6e6}, {0.4, at_04, time_at_04, 4e7}}) {
            StatePoint point{packing_fraction, count, time, more * segments, replicates, {}, 2};
            for (double k = hard / 16; k <= hard * (full ? 64 : hardest); k *= 4)
                point.stiffnesses.push_back(k);
            points.push_back(point);
        }
    }
    return points;
}

/// LAMMPS is dear and its replicates few: with five degrees of freedom Student's t would miss what
/// must be caught if a false alarm were as rare as elsewhere.
constexpr Risks risks{.false_alarm = 0.01};

/// Collisions that follow one another within this many durations of a contact are left out.
constexpr double mask_span = 1.5;

/// A 99 % quantile is judged by the share of the balls that lie beyond a limit: unlike the quantile
/// itself, it may be averaged over replicates of few balls.
constexpr double share_beyond_max = 0.01;
constexpr double plain_limit = 5;       // contact durations, at unit speed
constexpr double softened_limit = 1e-5; // [diameters]

/// Distances between soft and hard balls at the ends of all segments, at one stiffness [diameters].
struct Found {
    std::vector<double> plain;  // as they are
    std::vector<double> common; // the same, of the balls that are kept at all judged stiffnesses
    std::vector<double> richardson; // taken to the limit from this stiffness and the next
    std::vector<double> softened;   // from hard balls whose diameter yields
    double met = 0;                 // balls with a collision
};

inline void append(std::vector<double>& all, std::vector<double> const& more) {
    all.insert(all.end(), more.begin(), more.end());
}

/// Adds what one segment says; `next` is where the balls of the next stiffness ended, if any.
inline void add(Found& found, StatePoint const& point, Segment const& hard, double const stiffness,
                Eigen::Matrix3Xd const& end, Eigen::Matrix3Xd const* const next,
                Engines const& engines) {
    auto const mask_at = [](Segment const& segment, double const k) {
        return masked(segment, mask_span * reference::contact_duration(k));
    };
    Mask const mask = mask_at(hard, stiffness);
    double const softest_judged = point.stiffnesses[point.first_judged];
    Eigen::Matrix3Xd const& places = hard.end.positions;
    found.met += static_cast<double>(mask.met);
    append(found.plain, distances(end, places, mask.kept));
    append(found.common, distances(end, places, mask_at(hard, softest_judged).kept));
    if (next) append(found.richardson, distances(richardson(end, *next), places, mask.kept));
    // These have collisions of their own, some of which the hard balls lack.
    Segment const yielding = engines.yielding(point.system(), hard, stiffness, steps_per_contact);
    std::vector<bool> kept = mask_at(yielding, stiffness).kept;
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = kept[i] && mask.kept[i];
    append(found.softened, distances(end, yielding.end.positions, kept));
}

/// What one replicate gives for one stiffness, in the order in which a Measurement has it.
/// Distances [diameters]: median and 99 % quantile; -1 stands for those that there are not.
enum Value : std::size_t {
    kept_balls,
    kept_fraction,
    plain_median,
    plain_largest,
    plain_beyond, // share of balls beyond plain_limit
    common_median,
    richardson_median,
    richardson_largest,
    softened_median,
    softened_largest,
    softened_beyond, // share of balls beyond softened_limit
    value_count
};

inline Measurement summary(Found const& found, double const stiffness) {
    auto const part = [](std::vector<double> const& all, double const share) {
        return all.empty() ? -1 : quantile(all, share);
    };
    auto const beyond = [](std::vector<double> const& all, double const limit) {
        auto const count =
            std::count_if(all.begin(), all.end(), [&](double x) { return !(x <= limit); });
        return static_cast<double>(count) / static_cast<double>(all.size());
    };
    auto const kept = static_cast<double>(found.plain.size());
    constexpr double largest = 1 - share_beyond_max;
    return {kept,
            kept / found.met,
            part(found.plain, 0.5),
            part(found.plain, largest),
            beyond(found.plain, plain_limit * reference::contact_duration(stiffness)),
            part(found.common, 0.5),
            part(found.richardson, 0.5),
            part(found.richardson, largest),
            part(found.softened, 0.5),
            part(found.softened, largest),
            beyond(found.softened, softened_limit)};
}

/// The values of all stiffnesses, one after the other.
inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           Engines const& engines = {}) {
    auto const segments =
        segments_from(point.system(), equilibrated(point.system(), equilibration, seed),
                      point.segment_time, point.segments, engines.hard);
    SoftRuns const runs{point.system(), point.stiffnesses, steps_per_contact, 0};
    reference::LammpsFolder const folder;
    runs.run(folder, deck(), segments);
    std::vector<Found> found(point.stiffnesses.size());
    for (std::size_t s = 0; s < segments.size(); ++s) {
        std::vector<Eigen::Matrix3Xd> ends;
        for (std::size_t k = 0; k < found.size(); ++k)
            ends.push_back(runs.end(folder, k, s, segments[s].start));
        for (std::size_t k = 0; k < found.size(); ++k)
            add(found[k], point, segments[s], point.stiffnesses[k], ends[k],
                k + 1 < found.size() ? &ends[k + 1] : nullptr, engines);
    }
    Measurement values;
    for (std::size_t k = 0; k < found.size(); ++k) {
        Measurement const level = summary(found[k], point.stiffnesses[k]);
        values.insert(values.end(), level.begin(), level.end());
    }
    return values;
}

/// A state point with what was measured there.
struct Measured {
    StatePoint point;
    std::vector<Measurement> replicates;

    std::size_t hardest() const { return point.stiffnesses.size() - 1; }
    Estimate mean(std::size_t const level, Value const value) const {
        return mean_of(replicates, level * value_count + value);
    }
    /// Of log(common median) against log(stiffness) over what is judged, replicate by replicate.
    Estimate slope() const {
        return mean_of(replicates, [&](Measurement const& replicate) {
            std::vector<double> stiffnesses, medians;
            for (std::size_t k = point.first_judged; k <= hardest(); ++k) {
                stiffnesses.push_back(std::log(point.stiffnesses[k]));
                medians.push_back(std::log(replicate[k * value_count + common_median]));
            }
            return line_through(stiffnesses, medians).slope;
        });
    }
};

/// What is judged at one state point. The margins:
///   median      in contact durations. A pair that yields sets either ball back by half its normal
///               speed, a wall by the whole of it: medians 0.83 and 1.18 after one collision
///               (kT/m = 1), more after several.
///   slope       the error of first order falls as k^(-1/2).
///   Richardson  of second order: some t_c^2, 2e-6 at the softest judged.
///   softened    the same, less what head-on collisions do not have of it.
inline void enter(Ledger& ledger, Measured const& measured) {
    StatePoint const& point = measured.point;
    std::vector<std::string> const state{cell(point.packing_fraction), cell(point.count)};
    auto const add = [&](std::string const& name, Estimate const& found, double expected,
                         double margin) {
        ledger.compare(state, {name, name}, {{}, found, expected, 0, margin});
    };
    add("slope", measured.slope(), -0.5, 0.03);
    for (std::size_t k = point.first_judged; k <= measured.hardest(); ++k) {
        std::string const at = fmt::format(" at k={:.3g}", point.stiffnesses[k]);
        double const duration = reference::contact_duration(point.stiffnesses[k]);
        Estimate median = measured.mean(k, plain_median);
        median.value /= duration;
        median.error /= duration;
        add("median" + at, median, 1.1, 0.2);
        add("softened" + at, measured.mean(k, softened_median), 0, 1e-6);
        if (k < measured.hardest())
            add("Richardson" + at, measured.mean(k, richardson_median), 0, 1e-5);
    }
    add("kept", measured.mean(measured.hardest(), kept_fraction), 1, 0.1);
}

/// A share of balls beyond a limit over all stiffnesses that are judged and all state points of a
/// packing fraction, which must have as many replicates. A near miss that becomes a hit, or the
/// reverse, takes several balls with it: few replicates would not do.
inline void enter_beyond(Ledger& ledger, std::vector<Measured> const& points,
                         double const packing_fraction, Value const value) {
    std::vector<double> balls(points.front().replicates.size()), outside = balls;
    for (Measured const& measured : points) {
        if (measured.point.packing_fraction != packing_fraction) continue;
        for (std::size_t k = measured.point.first_judged; k <= measured.hardest(); ++k)
            for (std::size_t r = 0; r < balls.size(); ++r) {
                double const* const at = measured.replicates[r].data() + k * value_count;
                balls[r] += at[kept_balls];
                outside[r] += at[kept_balls] * at[value];
            }
    }
    double const all = std::accumulate(balls.begin(), balls.end(), 0.0);
    for (std::size_t r = 0; r < balls.size(); ++r) outside[r] /= balls[r];
    // None among so many may be no more than chance.
    double const one_ball = 1 / all;
    char const* const name =
        value == plain_beyond ? "beyond 5 contact durations" : "beyond 1e-5; softened";
    ledger.compare({cell(packing_fraction), "all"}, {name, name},
                   {{}, mean_of(outside), 0, one_ball, share_beyond_max});
}

} // namespace clack::validation::trajectories_vs_lammps
