#pragma once
// How fast each method moves the same balls: state points, one measurement, and what is asked of
// the rates.

#include "simulation/model_choice.hpp"
#include "state/errors.hpp"
#include "validation/harness/campaign.hpp"
#include "validation/harness/engine_maker.hpp"
#include "validation/harness/lattice_start.hpp"
#include "validation/harness/options.hpp"
#include "validation/harness/processor_time.hpp"
#include "validation/harness/verdict.hpp"
#include "validation/speed_parts.hpp"
#include "validation/speed_peer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace clack::validation::speed {

/// Who takes turns, and where.
constexpr std::array methods{Method::table, Method::heap, Method::fast};
constexpr std::array runners{"table", "heap", "fast", "peer"};
constexpr std::array boundaries{Boundary::periodic, Boundary::walls};
enum : std::size_t { table, heap, fast, peer }; // places in `methods` and `runners`
enum : std::size_t { in_periodic, in_walls };   // places in `boundaries`
constexpr double none = std::numeric_limits<double>::quiet_NaN();

inline char const* name_of(Boundary const boundary) {
    return boundary == Boundary::walls ? "walls" : "periodic";
}

/// Balls that all methods move, in both containers.
struct Point {
    std::int64_t count;
    double packing_fraction;
    double equilibration;           // collisions per ball before anything is timed
    std::uint64_t collisions;       // timed, of each method but the table
    std::uint64_t table_collisions; // 0 where the table would take too long

    std::string text() const {
        return fmt::format("count={} packing_fraction={}", count, packing_fraction);
    }
    System system(Boundary const boundary) const {
        System made;
        made.boundary = boundary;
        made.count = count;
        made.side =
            std::cbrt(static_cast<double>(count) * std::numbers::pi / (6 * packing_fraction));
        return made;
    }
    std::uint64_t collisions_of(std::size_t const method) const {
        return method == table ? table_collisions : collisions;
    }
};

/// All that is measured.
struct Plan {
    std::vector<std::int64_t> counts;
    std::vector<double> packing_fractions;
    double timed_per_ball;          // collisions per ball that are timed of each method ...
    std::uint64_t timed_least;      // ... and the fewest
    std::int64_t table_largest;     // number of balls
    std::int64_t equilibrated_well; // more balls than this go a quarter of the way only
    int replicates;

    Point point(std::int64_t const count, double const packing_fraction) const {
        auto const balls = static_cast<double>(count);
        constexpr double pairs = 4e6; // that the table is given time to look at
        return {.count = count,
                .packing_fraction = packing_fraction,
                .equilibration = count <= equilibrated_well ? 20.0 : 5.0,
                .collisions =
                    std::max(timed_least, static_cast<std::uint64_t>(timed_per_ball * balls / 2)),
                .table_collisions =
                    count <= table_largest ? static_cast<std::uint64_t>(pairs / balls) : 0};
    }
    std::vector<Point> points() const {
        std::vector<Point> all;
        for (double const packing_fraction : packing_fractions)
            for (std::int64_t const count : counts) all.push_back(point(count, packing_fraction));
        return all;
    }
};

/// From a gas so thin that a ball flies through many cells to a crystal, which the lattice of the
/// start already is.
inline Plan plan(Profile const profile) {
    std::vector<double> const packing_fractions{0.01, 0.05, 0.2, 0.4, 0.49, 0.54};
    if (profile == Profile::quick)
        return {.counts = {500, 4'000, 32'000},
                .packing_fractions = packing_fractions,
                .timed_per_ball = 0.5,
                .timed_least = 6'000,
                .table_largest = 4'000,
                .equilibrated_well = 4'000,
                .replicates = 5};
    return {.counts = {500, 4'000, 32'000, 256'000, 1'000'000},
            .packing_fractions = packing_fractions,
            .timed_per_ball = 2,
            .timed_least = 100'000,
            .table_largest = 32'000,
            .equilibrated_well = 256'000,
            .replicates = 5};
}

/// What was found out about one runner in one container; none of it where it did not run.
struct Cost {
    double seconds = none; // processor time of a collision
    double bytes = none;   // memory of the engine per ball
    Shares shares{none, none, none, none, none};
};

/// What one replicate found out.
using Costs = std::array<std::array<Cost, runners.size()>, boundaries.size()>;

/// The same as the campaign keeps it.
inline Measurement flat(Costs const& costs) {
    Measurement all;
    for (auto const& in_container : costs) {
        for (Cost const& cost : in_container) {
            all.push_back(cost.seconds);
            all.push_back(cost.bytes);
            all.insert(all.end(), cost.shares.begin(), cost.shares.end());
        }
    }
    return all;
}
inline Costs costs_of(Measurement const& all) {
    Costs costs;
    auto next = all.begin();
    for (auto& in_container : costs) {
        for (Cost& cost : in_container) {
            cost.seconds = *next++;
            cost.bytes = *next++;
            for (double& share : cost.shares) share = *next++;
        }
    }
    return costs;
}

/// Balls in equilibrium, for all methods to start from.
inline Start equilibrated(Point const& point, Boundary const boundary, std::uint64_t const seed) {
    System const system = point.system(boundary);
    auto const engine = make_true_method(system, Method::fast, lattice_start(system, seed));
    engine->advance({.ball_collisions = static_cast<std::uint64_t>(
                         point.equilibration * static_cast<double>(point.count) / 2)});
    Snapshot const snapshot = engine->snapshot();
    return {snapshot.positions, snapshot.velocities};
}

/// One method on its way, timed a slice at a time.
struct Run {
    std::size_t boundary, method;
    std::unique_ptr<Engine> engine;
    std::uint64_t slice;    // collisions
    std::uint64_t done = 0; // collisions, timed or not
    double seconds = 0;     // of the timed ones

    static constexpr std::uint64_t slices = 3;

    /// A third of a slice goes first, untimed: others have had the caches meanwhile.
    void go() {
        done += slice / 3;
        engine->advance({.ball_collisions = done});
        double const begin = processor_seconds();
        done += slice;
        engine->advance({.ball_collisions = done});
        seconds += processor_seconds() - begin;
    }
};

inline std::vector<Run> runs_of(Point const& point, std::vector<Start> const& starts,
                                MethodMaker const& make) {
    std::vector<Run> runs;
    for (std::size_t b = 0; b < boundaries.size(); ++b) {
        for (std::size_t m = 0; m < methods.size(); ++m) {
            if (point.collisions_of(m) == 0) continue;
            runs.push_back({.boundary = b,
                            .method = m,
                            .engine = make(point.system(boundaries[b]), methods[m], starts[b]),
                            .slice = point.collisions_of(m) / Run::slices});
        }
    }
    return runs;
}

/// Two methods that have gone apart are not two speeds of one run.
inline void require_one_way(Point const& point, std::vector<Run> const& runs) {
    for (std::size_t k = 1; k < runs.size(); ++k) {
        Run const& a = runs[k - 1];
        Run const& b = runs[k];
        if (a.boundary != b.boundary || a.done != b.done) continue;
        if (a.engine->snapshot().positions == b.engine->snapshot().positions) continue;
        throw LawBroken(fmt::format("{} {}: after {} collisions {} and {} have the balls elsewhere",
                                    name_of(boundaries[a.boundary]), point.text(), a.done,
                                    runners[a.method], runners[b.method]));
    }
}

/// All methods in both containers, slice by slice in turn, so that a machine that slows down
/// meanwhile slows all of them; then each once more, watched.
///   peer_command   to be run in turn with them (speed_peer.hpp); empty for none
inline Costs measure(Point const& point, std::uint64_t const seed,
                     std::string const& peer_command = {},
                     MethodMaker const& make = make_true_method) {
    std::vector<Start> starts;
    for (Boundary const boundary : boundaries)
        starts.push_back(equilibrated(point, boundary, seed));
    Costs costs;
    auto runs = runs_of(point, starts, make);
    for (std::uint64_t slice = 0; slice < Run::slices; ++slice) {
        for (Run& run : runs) run.go();
        if (!peer_command.empty() && slice == 0) // it begins anew each time: once is enough
            costs[in_periodic][peer].seconds =
                peer_seconds(peer_command, point.count, point.packing_fraction, point.equilibration,
                             point.collisions, seed);
    }
    require_one_way(point, runs);
    for (Run const& run : runs) {
        Cost& cost = costs[run.boundary][run.method];
        cost.seconds = run.seconds / static_cast<double>(Run::slices * run.slice);
        cost.bytes = static_cast<double>(run.engine->bytes()) / static_cast<double>(point.count);
    }
    runs.clear(); // memory for those that are watched
    for (std::size_t b = 0; b < boundaries.size(); ++b)
        for (std::size_t m = 0; m < methods.size(); ++m)
            if (point.collisions_of(m) > 0)
                costs[b][m].shares = shares(point.system(boundaries[b]), methods[m], starts[b],
                                            point.collisions_of(m) / 2);
    return costs;
}

} // namespace clack::validation::speed
