#pragma once
// What a start and a collision cost, against the number of balls: sizes, one measurement, and the
// powers that it should follow.

#include "simulation/model_choice.hpp"
#include "validation/harness/experiment.hpp"
#include "validation/mutants/engine_maker.hpp"
#include "validation/records/campaign.hpp"
#include "validation/statistics/estimate.hpp"
#include "validation/statistics/verdict.hpp"
#include "validation/timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace clack::validation::complexity {

/// One method over its sizes, and the powers of n that its costs should follow: the report's
/// section 4 for its table; for cells one visit a ball to start and nothing that grows afterwards.
struct Ladder {
    Method method;
    std::int64_t largest;     // number of balls; sizes double from Plan::smallest on
    std::uint64_t collisions; // of either kind, timed at each size
    double start_power, collision_power;
};

/// All that is measured.
struct Plan {
    double packing_fraction;
    double equilibration;                  // ball-ball collisions per ball before anything is timed
    std::int64_t smallest, largest_fitted; // number of balls
    std::vector<Ladder> ladders;
    int replicates;

    std::int64_t largest() const { return std::ranges::max(ladders, {}, &Ladder::largest).largest; }
    std::string text() const {
        return fmt::format("packing_fraction={} counts={}-{}", packing_fraction, smallest,
                           largest());
    }
    std::vector<std::int64_t> counts(std::int64_t last) const {
        std::vector<std::int64_t> counts;
        for (std::int64_t count = smallest; count <= last; count *= 2) counts.push_back(count);
        return counts;
    }
};

/// A gas between walls, as the report has it. Powers are fitted to the sizes that a level-2 cache
/// of 1 MiB holds, at some 250 bytes a ball: beyond, memory is timed and not the number of
/// operations.
inline Plan plan(Profile const profile) {
    std::int64_t const largest = profile == Profile::quick ? 131'072 : 1'048'576;
    return {.packing_fraction = 0.2,
            .equilibration = 1,
            .smallest = 512,
            .largest_fitted = 4'096,
            .ladders = {{Method::table, 16'384, 1'000, 2, 1},
                        {Method::heap, largest, 20'000, 1, 0},
                        {Method::fast, largest, 20'000, 1, 0}},
            .replicates = profile == Profile::quick ? 8 : 20};
}

/// A difference in an exponent that would not matter. The powers in question are integers: below
/// half their distance an exponent belongs to one of them alone, and the caches, which hold less of
/// a larger system long before its records outgrow them, have room.
constexpr double margin = 0.4;

/// A gas in equilibrium, for all methods to start from.
inline std::pair<System, Start> gas(Plan const& plan, std::int64_t const count,
                                    std::uint64_t const seed) {
    Scene scene;
    scene.system.boundary = Boundary::walls;
    scene.system.count = count;
    scene.system.side =
        std::cbrt(static_cast<double>(count) * std::numbers::pi / (6 * plan.packing_fraction));
    scene.arrangement = Arrangement::random;
    scene.seed = seed;
    scene.method = Method::fast;
    auto const engine = make_true_engine(scene);
    engine->advance({.ball_collisions = static_cast<std::uint64_t>(
                         plan.equilibration * static_cast<double>(count) / 2)});
    Snapshot const snapshot = engine->snapshot();
    return {scene.system, {snapshot.positions, snapshot.velocities}};
}

/// What one method costs at one size.
struct Cost {
    double start;     // of all predictions before the first collision  [s]
    double collision; // mean over collisions of either kind             [s]
};

/// Short starts are repeated until they have taken long enough to be timed. The collisions all lie
/// in the first epoch: the change of epoch, a new start every few dozen collisions per ball, adds a
/// few per cent to each at any size.
inline Cost cost_of(Ladder const& ladder, System const& system, Start const& start,
                    MethodMaker const& make) {
    constexpr double long_enough = 0.01; // [s], ten thousand times the clock's resolution
    std::unique_ptr<Engine> engine;
    double const begin = processor_seconds();
    double start_seconds = 0;
    int starts = 0;
    for (; start_seconds < long_enough; ++starts) {
        engine = make(system, ladder.method, start);
        start_seconds = processor_seconds() - begin;
    }
    double const moving = processor_seconds();
    Tallies const& tallies = engine->tallies();
    while (tallies.ball_collisions + tallies.wall_collisions < ladder.collisions)
        engine->advance({.events = ladder.collisions / 10});
    double const collisions =
        static_cast<double>(tallies.ball_collisions + tallies.wall_collisions);
    return {start_seconds / starts, (processor_seconds() - moving) / collisions};
}

/// One sweep over all sizes, all methods after one another at each, so that a machine that slows
/// down meanwhile slows all of them. Start and collision cost alternate, ladder after ladder,
/// smallest size first.
inline Measurement measure(Plan const& plan, std::uint64_t const seed,
                           MethodMaker const& make = make_true_method) {
    std::vector<Measurement> costs(plan.ladders.size());
    for (std::int64_t const count : plan.counts(plan.largest())) {
        auto const [system, start] = gas(plan, count, seed);
        for (std::size_t k = 0; k < costs.size(); ++k) {
            if (count > plan.ladders[k].largest) continue;
            Cost const cost = cost_of(plan.ladders[k], system, start, make);
            costs[k].push_back(cost.start);
            costs[k].push_back(cost.collision);
        }
    }
    Measurement all;
    for (Measurement const& ladder : costs) all.insert(all.end(), ladder.begin(), ladder.end());
    return all;
}

/// A cost that grows as a power of n.
struct Power {
    double exponent;
    double factor; // cost at n = 1, extrapolated  [s]

    double at(double count) const { return factor * std::pow(count, exponent); }
};

/// Least squares through the logarithms of as many costs as there are counts.
inline Power fit_power(std::vector<std::int64_t> const& counts, std::vector<double> const& costs) {
    std::vector<double> x, y;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        x.push_back(std::log(static_cast<double>(counts[k])));
        y.push_back(std::log(costs[k]));
    }
    StraightLine const line = line_through(x, y);
    return {line.slope, std::exp(line.at_0)};
}

enum class Work : std::size_t { start, collision };
inline char const* name_of(Work const work) { return work == Work::start ? "start" : "collision"; }

/// The costs of one ladder in one sweep, smallest size first.
inline std::vector<double> costs_of(Plan const& plan, std::size_t const ladder, Work const quantity,
                                    Measurement const& sweep) {
    std::size_t first = static_cast<std::size_t>(quantity);
    for (std::size_t k = 0; k < ladder; ++k)
        first += 2 * plan.counts(plan.ladders[k].largest).size();
    std::vector<double> costs;
    for (std::size_t k = 0; k < plan.counts(plan.ladders[ladder].largest).size(); ++k)
        costs.push_back(sweep[first + 2 * k]);
    return costs;
}

/// The exponent of one ladder over all sweeps beside the one it should have. Each sweep is fitted
/// on its own, so the error holds what changes from sweep to sweep.
inline Comparison compare(Plan const& plan, std::size_t const ladder, Work const quantity,
                          std::vector<Measurement> const& sweeps) {
    Ladder const& expected = plan.ladders[ladder];
    auto const exponent = [&](Measurement const& sweep) {
        return fit_power(plan.counts(plan.largest_fitted), costs_of(plan, ladder, quantity, sweep))
            .exponent;
    };
    return {.measured = mean_of(sweeps, exponent),
            .reference = quantity == Work::start ? expected.start_power : expected.collision_power,
            .margin = margin};
}

} // namespace clack::validation::complexity
