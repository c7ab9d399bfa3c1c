#pragma once
// What the failure atlas asks of every method alike: the balls at a few moments, and whom they met.

#include "validation/atlas_problem.hpp"
#include "validation/statistics/estimate.hpp"

#include <algorithm>
#include <cmath>

namespace clack::validation::atlas {

constexpr double double_roundoff = 0x1p-53, float_roundoff = 0x1p-24;

/// How far a scene's own answer moves when its start is changed by rounding: what no method can do
/// better than.
struct Spread {
    std::vector<double> places, speeds; // a number a frame: of the ball that moves most
    bool order_known = true;            // whether the balls meet in one order all the same
};

/// The answer to a problem, in quad precision or in closed form.
struct Reference {
    std::vector<Frame> frames{};
    Partners partners{};
    std::vector<Meeting> meetings{};
    Spread in_float{}, in_double{};
    bool has_limit = true; // or the answer jumps however small the change of the start
    bool exists = false;

    Spread const& spread(double roundoff) const {
        return roundoff > double_roundoff ? in_float : in_double;
    }
};

/// Distances of the balls of two frames, the largest; through the nearest image where space repeats
/// itself. Not a number where a place is none.
inline double largest_distance(Problem const& problem, Eigen::Matrix3Xd const& one,
                               Eigen::Matrix3Xd const& other) {
    Eigen::Matrix3Xd apart = one - other;
    double const side = problem.system.side;
    if (problem.system.boundary == Boundary::periodic)
        apart -= side * (apart / side).array().round().matrix();
    double largest = 0;
    for (double const distance : apart.colwise().norm()) largest = worse(largest, distance);
    return largest;
}

inline double largest_change(Frame const& one, Frame const& other) {
    return (one.velocities - other.velocities).colwise().norm().maxCoeff();
}

/// Adds what two answers differ by.
inline void widen(Spread& spread, Problem const& problem, Trace const& base, Trace const& shaken) {
    spread.places.resize(base.frames.size());
    spread.speeds.resize(base.frames.size());
    std::int64_t const count = problem.system.count;
    spread.order_known &= partners_of(shaken.meetings, count) == partners_of(base.meetings, count);
    for (std::size_t k = 0; k < base.frames.size(); ++k) {
        bool const there = k < shaken.frames.size();
        double const far = infinity<double>;
        Frame const& frame = base.frames[k];
        spread.places[k] = std::max(
            spread.places[k],
            there ? largest_distance(problem, frame.places, shaken.frames[k].places) : far);
        spread.speeds[k] =
            std::max(spread.speeds[k], there ? largest_change(frame, shaken.frames[k]) : far);
    }
}

/// The answer by the engine in quad precision, which the shaken starts show the worth of.
inline Reference reference_of(Problem const& problem) {
    Reference reference;
    if (!problem.has_reference) return reference;
    Maker const make = [](System const& system, Checkpoint const& checkpoint) {
        return make_engine(system, Method::fast, Precision::quadruple, checkpoint);
    };
    auto const flown = [&](Shake const& shake) {
        return fly(problem, make, Precision::quadruple, shake);
    };
    Trace const base = flown({});
    reference.exists = true;
    // Far below what a double can tell: an answer that moves by more than a millionth for that has
    // no limit. Chaos cannot do it: it would have to grow by so much more than the digits of
    // double precision that scenes with a reference are too short.
    constexpr double hardly = 2e-32;
    Spread least;
    for (double const sign : {-1, 1}) {
        widen(reference.in_double, problem, base, flown({sign * double_roundoff, 1}));
        widen(reference.in_float, problem, base, flown({sign * float_roundoff, 2}));
        widen(least, problem, base, flown({sign * hardly, 3}));
    }
    double const jump = *std::max_element(least.speeds.begin(), least.speeds.end());
    reference.has_limit = jump < 1e-6 * problem.fastest();
    reference.frames = base.frames;
    if (problem.exact)
        std::transform(problem.times.begin(), problem.times.end(), reference.frames.begin(),
                       problem.exact);
    reference.meetings = base.meetings;
    reference.partners = partners_of(base.meetings, problem.system.count);
    return reference;
}

/// How a method fares, from good to bad.
enum class Kind { ok, digits, order, overlap, energy, lost, hang, crash, not_run };

/// Whether more is wrong than digits.
inline bool is_gross(Kind kind) { return kind > Kind::digits && kind != Kind::not_run; }

/// Why a method is not run.
enum class Absence { none, too_long, too_wide, turns_round, missing };

/// How far a run went, and how well it kept its laws on the way.
struct Extent {
    double collisions = 0;      // between balls
    double energy_drift = 0;    // relative
    double deepest_overlap = 0; // at a collision  [diameters]
};

struct Judged {
    Kind kind = Kind::ok;
    double digits = 0; // that the worst of the checks has lost beyond rounding
    Absence absence = Absence::none;
    Extent extent{};

    static Judged absent(Absence why) { return {Kind::not_run, 0, why, {}}; }
};

/// The worst of all frames of each check, in units of what rounding allows.
struct Excess {
    double track = 0, overlap = 0, energy = 0;
    double drift = 0;                             // of the energy, relative
    bool lost = false, deep = false, hot = false; // beyond all rounding
};

/// How many times the scene's own spread, and a rounding of places, flights and speeds for each
/// collision, a method may be off: the engine's own errors are a tenth of that.
constexpr double allowance = 16;

inline void look(Excess& excess, Problem const& problem, Frame const& frame,
                 double const place_bound) {
    System const& system = problem.system;
    constexpr double gross = 1e-3;
    double nearest = infinity<double>;
    for (Eigen::Index i = 0; i < frame.places.cols(); ++i) {
        for (Eigen::Index j = i + 1; j < frame.places.cols(); ++j) {
            Eigen::Vector3d apart = frame.places.col(j) - frame.places.col(i);
            if (system.boundary == Boundary::periodic)
                apart -= system.side * (apart / system.side).array().round().matrix();
            nearest = std::min(nearest, apart.norm());
        }
    }
    double const depth = std::max(0.0, system.diameter - nearest);
    excess.overlap = std::max(excess.overlap, depth / place_bound);
    excess.deep |= depth > gross * system.diameter + place_bound;
    if (!(frame.places.minCoeff() >= -place_bound) ||
        !(frame.places.maxCoeff() <= system.side + place_bound) || !frame.places.allFinite() ||
        !frame.velocities.allFinite())
        excess.lost = true;
}

inline Excess excess_of(Problem const& problem, Reference const& reference, Trace const& trace,
                        double const roundoff) {
    Excess excess;
    double const side = problem.system.side, fastest = problem.fastest();
    double const energy = problem.start.velocities.squaredNorm();
    // A flight is as long as an epoch, four sides at most.
    double const place_bound = allowance * roundoff * 5 * side;
    double const drift_bound = allowance * roundoff * (2 + std::sqrt(trace.collisions_per_ball));
    double const meetings = 1 + trace.collisions_per_ball;
    for (std::size_t k = 0; k < trace.frames.size(); ++k) {
        Frame const& frame = trace.frames[k];
        look(excess, problem, frame, place_bound);
        double const drift = std::abs(frame.velocities.squaredNorm() / energy - 1);
        excess.drift = worse(excess.drift, drift);
        excess.energy = std::max(excess.energy, drift / drift_bound);
        excess.hot |= !(drift <= 1e-3 + drift_bound);
        if (!reference.exists || !reference.has_limit) continue;
        Spread const& spread = reference.spread(roundoff);
        double const place = largest_distance(problem, frame.places, reference.frames[k].places);
        double const change = largest_change(frame, reference.frames[k]);
        double const place_room = allowance * spread.places[k] + meetings * place_bound;
        double const speed_room = allowance * (spread.speeds[k] + meetings * roundoff * fastest);
        excess.track = std::max({excess.track, place / place_room, change / speed_room});
    }
    return excess;
}

inline Judged judge(Problem const& problem, Reference const& reference, Trace const& trace,
                    double const roundoff) {
    Excess const excess = excess_of(problem, reference, trace, roundoff);
    double const worst = std::max({excess.track, excess.overlap, excess.energy, 1.0});
    double const digits = std::min(std::log10(worst), 16.0);
    constexpr double law_digits = 3; // beyond rounding the engine's own law lets none through
    Extent const extent{trace.collisions, excess.drift, trace.deepest_overlap};
    auto const is = [&](Kind kind) { return Judged{kind, digits, Absence::none, extent}; };
    if (trace.end == End::crash) return is(Kind::crash);
    if (trace.end == End::hang) return is(Kind::hang);
    if (trace.end == End::lost || excess.lost) return is(Kind::lost);
    if (trace.end == End::overlap || excess.deep) return is(Kind::overlap);
    if (trace.end == End::energy || excess.hot) return is(Kind::energy);
    bool const followed = reference.exists && reference.has_limit;
    if (followed && reference.spread(roundoff).order_known &&
        partners_of(trace.meetings, problem.system.count) != reference.partners)
        return is(Kind::order);
    if (trace.end == End::apart)
        return {Kind::digits, std::max(digits, law_digits), Absence::none, extent};
    if (!followed && excess.overlap > 1) return is(Kind::overlap);
    if (!followed && excess.energy > 1) return is(Kind::energy);
    return is(worst > 1 ? Kind::digits : Kind::ok);
}

} // namespace clack::validation::atlas
