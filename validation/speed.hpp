#pragma once
// How fast each method moves the same balls: state points, one measurement, and what is asked of
// the rates.

#include "simulation/model_choice.hpp"
#include "state/errors.hpp"
#include "validation/harness/experiment.hpp"
#include "validation/lattice_start.hpp"
#include "validation/mutants/engine_maker.hpp"
#include "validation/speed_parts.hpp"
#include "validation/speed_peer.hpp"
#include "validation/timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

namespace clack::validation::speed {

/// Who takes turns, and where.
constexpr std::array methods{Method::table, Method::heap, Method::fast};
constexpr std::array runners{"table", "heap", "fast", "peer"};
constexpr std::array boundaries{Boundary::periodic, Boundary::walls};
enum : std::size_t { table, heap, fast, peer }; // places in `methods` and `runners`
enum : std::size_t { in_periodic, in_walls };   // places in `boundaries`

constexpr int replicates = 5;
constexpr std::int64_t not_small = 4'000; // balls, from where on the aims hold

/// Balls that all methods move, in both containers.
struct Point {
    std::int64_t count;
    double packing_fraction;
    double equilibration;           // collisions per ball before anything is timed
    std::uint64_t collisions;       // timed, of each method but the table
    std::uint64_t table_collisions; // 0 where the table would take too long
    bool watched = false;           // to see where the time goes; in the periodic cube

    std::string text() const {
        return fmt::format("count={} packing_fraction={}", count, packing_fraction);
    }
    System system(std::size_t const boundary) const {
        return cube(boundaries[boundary], count, packing_fraction);
    }
    std::uint64_t collisions_of(std::size_t const method) const {
        return method == table ? table_collisions : collisions;
    }
};

/// From a gas so thin that a ball flies through many cells to a crystal, which the lattice of the
/// start already is. The table is given time to look at so many pairs.
inline std::vector<Point> points(Profile const profile) {
    bool const full = profile == Profile::full;
    std::vector<std::int64_t> counts{500, not_small, 32'000};
    if (full) counts.insert(counts.end(), {256'000, 1'000'000});
    std::int64_t const well = full ? 256'000 : not_small, table_largest = full ? 32'000 : not_small;
    constexpr std::uint64_t pairs = 4'000'000;
    std::vector<Point> all;
    for (double const packing_fraction : {0.01, 0.05, 0.2, 0.4, 0.49, 0.54}) {
        for (std::int64_t const count : counts) {
            auto const balls = static_cast<std::uint64_t>(count);
            all.push_back({.count = count,
                           .packing_fraction = packing_fraction,
                           .equilibration = count <= well ? 20.0 : 5.0,
                           .collisions = full ? std::max<std::uint64_t>(100'000, balls)
                                              : std::max<std::uint64_t>(6'000, balls / 4),
                           .table_collisions = count <= table_largest ? pairs / balls : 0,
                           .watched = full || count == not_small});
        }
    }
    return all;
}

/// What one replicate measures of each runner in each container, not a number where it did not: the
/// processor time of a collision, the memory per ball, and which shares of the time its parts take.
enum Value : std::size_t { seconds, bytes, first_part, value_count = first_part + part_count };
constexpr std::size_t place_of(std::size_t const boundary, std::size_t const runner,
                               std::size_t const value = seconds) {
    return (boundary * runners.size() + runner) * value_count + value;
}

/// Balls in equilibrium, for all methods to start from.
inline Start equilibrated(Point const& point, std::size_t const boundary,
                          std::uint64_t const seed) {
    System const system = point.system(boundary);
    auto const engine = make_true_method(system, Method::fast, lattice_start(system, seed));
    engine->advance({.ball_collisions = static_cast<std::uint64_t>(
                         point.equilibration * static_cast<double>(point.count) / 2)});
    return start_of(*engine);
}

/// One method on its way.
struct Run {
    std::size_t boundary, method;
    TimedRun timed;
    std::uint64_t slice; // collisions
    double seconds = 0;

    static constexpr std::uint64_t slices = 3;
};

inline std::vector<Run> runs_of(Point const& point, std::vector<Start> const& starts,
                                MethodMaker const& make) {
    std::vector<Run> runs;
    for (std::size_t b = 0; b < boundaries.size(); ++b)
        for (std::size_t m = 0; m < methods.size(); ++m)
            if (point.collisions_of(m) > 0)
                runs.push_back({.boundary = b,
                                .method = m,
                                .timed = {make(point.system(b), methods[m], starts[b])},
                                .slice = point.collisions_of(m) / Run::slices});
    return runs;
}

/// Two methods that have gone apart are not two speeds of one run.
inline void require_one_way(Point const& point, std::vector<Run> const& runs) {
    for (std::size_t k = 1; k < runs.size(); ++k) {
        Run const& a = runs[k - 1];
        Run const& b = runs[k];
        if (a.boundary != b.boundary || a.timed.done != b.timed.done) continue;
        if (start_of(*a.timed.engine).positions == start_of(*b.timed.engine).positions) continue;
        throw LawBroken(fmt::format("{} {}: after {} collisions {} and {} have the balls elsewhere",
                                    name_of(boundaries[a.boundary]), point.text(), a.timed.done,
                                    runners[a.method], runners[b.method]));
    }
}

/// All methods in both containers, slice by slice in turn, so that a machine that slows down
/// meanwhile slows all of them; then some once more, watched.
///   peer_command   to be run in turn with them (speed_peer.hpp); empty for none
inline Measurement measure(Point const& point, std::uint64_t const seed,
                           std::string const& peer_command = {},
                           MethodMaker const& make = make_true_method) {
    std::vector<Start> starts;
    for (std::size_t b = 0; b < boundaries.size(); ++b)
        starts.push_back(equilibrated(point, b, seed));
    Measurement all(place_of(boundaries.size(), 0), std::numeric_limits<double>::quiet_NaN());
    auto runs = runs_of(point, starts, make);
    for (std::uint64_t slice = 0; slice < Run::slices; ++slice) {
        for (Run& run : runs) run.seconds += run.timed.go(run.slice);
        if (!peer_command.empty() && slice == 0) // it begins anew each time: once is enough
            all[place_of(in_periodic, peer)] =
                peer_seconds(peer_command, point.count, point.packing_fraction, point.equilibration,
                             point.collisions, seed);
    }
    require_one_way(point, runs);
    for (Run const& run : runs) {
        all[place_of(run.boundary, run.method)] =
            run.seconds / static_cast<double>(Run::slices * run.slice);
        all[place_of(run.boundary, run.method, bytes)] =
            static_cast<double>(run.timed.engine->bytes()) / static_cast<double>(point.count);
        if (!point.watched || run.boundary == in_walls) continue;
        Shares const parts = shares(point.system(in_periodic), methods[run.method],
                                    starts[in_periodic], point.collisions_of(run.method) / 2);
        std::ranges::copy(parts, all.begin() + static_cast<std::ptrdiff_t>(
                                                   place_of(in_periodic, run.method, first_part)));
    }
    return all;
}

} // namespace clack::validation::speed
