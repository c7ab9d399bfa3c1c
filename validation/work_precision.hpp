#pragma once
// What one more digit costs, and where it can no longer be bought: state points, and one scene by
// the engine in all its floating types and methods. Other methods stand in stepped_runs.hpp.

#include "neighbours/every_pair.hpp"
#include "reference/horizon.hpp"
#include "scheduling/collision_table.hpp"
#include "simulation/epoch.hpp"
#include "simulation/model_choice.hpp"
#include "simulation/simulation.hpp"
#include "validation/collision_prefix.hpp"
#include "validation/error_growth.hpp"
#include "validation/exact_places.hpp"
#include "validation/lattice_start.hpp"
#include "validation/mutants/engine_maker.hpp"
#include "validation/timing.hpp"

#include <boost/multiprecision/cpp_dec_float.hpp>

#include <array>
#include <map>

namespace clack::validation::work_precision {

using collision_prefix::matched;
using collision_prefix::Partners;
using collision_prefix::partners_of;

constexpr double equilibration = 30; // collisions per ball
constexpr double final_time = 2;     // mean free times: there errors of position are compared

struct StatePoint {
    double packing_fraction;
    std::int64_t count;
    int replicates;
    bool with_decimal = false;

    /// A side that float holds exactly.
    System system() const {
        double const side =
            std::cbrt(static_cast<double>(count) * std::numbers::pi / (6 * packing_fraction));
        return {.side = std::round(side * 0x1p16) * 0x1p-16, .count = count};
    }
    /// What a campaign's key has to say beside the method and its knobs.
    std::string text(std::string const& what) const {
        return fmt::format("{} packing_fraction={} count={} decimal={}", what, packing_fraction,
                           count, with_decimal);
    }
    /// Collisions per ball until an error of the rounding unit has grown to a diameter: the line
    /// that is drawn.
    double limit(double const unit) const {
        return -std::log(unit * system().side) /
               reference::lyapunov_exponent_per_collision(system());
    }
};

inline std::vector<StatePoint> state_points(Profile const profile) {
    bool const full = profile == Profile::full;
    std::vector<StatePoint> points;
    for (double const packing_fraction : {0.05, 0.2, 0.4}) {
        points.push_back({packing_fraction, 27, full ? 40 : 5, full || packing_fraction == 0.05});
        points.push_back({packing_fraction, 100, full ? 20 : 3});
        points.push_back({packing_fraction, 1000, full ? 6 : 1});
    }
    return points;
}

inline constexpr std::array precisions{Precision::single_, Precision::double_, Precision::extended,
                                       Precision::quadruple};
inline constexpr std::array methods{Method::table, Method::heap, Method::fast};

/// Balls in equilibrium, and how often they collide.
struct Scenery {
    System system;
    Start start;
    double mean_free_time;

    double mean_free_path() const { // at kT = m = 1
        return mean_free_time * std::sqrt(8 / std::numbers::pi);
    }
};

inline Scenery scenery(StatePoint const& point, std::uint64_t const seed) {
    Scenery made{point.system(), equilibrated(point.system(), equilibration, seed), 0};
    auto const engine = make_true_method(made.system, Method::automatic, made.start);
    engine->advance({.ball_collisions = static_cast<std::uint64_t>(10 * point.count)});
    made.mean_free_time = engine->time() / 20;
    return made;
}

/// A run: where the balls are at the final time, and whom they have met until its end.
struct Run {
    QuadPlaces places;
    Partners partners;
    double deepest_overlap = 0, energy_drift = 0; // at the end
};

/// Who meets whom, and how an error grows on the way where somebody asks.
struct Recorder final : CollisionObserver {
    MeetingRecorder meetings;
    ErrorGrowth* growth = nullptr;

    void operator()(Collision<double> const& collision) override {
        meetings(collision);
        if (growth) (*growth)(collision);
    }
};

/// Goes on until so many mean free times.
inline Run run(Engine& engine, Scenery const& scenery, double const until,
               ErrorGrowth* const growth = nullptr) {
    Run run;
    Recorder recorder;
    recorder.growth = growth;
    double const time = final_time * scenery.mean_free_time;
    quad const energy = exact_square_speed(engine.checkpoint(), scenery.system);
    engine.advance({.time = time}, &recorder);
    run.places = exact_places(engine.checkpoint(), scenery.system, time);
    engine.advance({.time = std::max(until * scenery.mean_free_time, time)}, &recorder);
    run.partners = partners_of(recorder.meetings.meetings, scenery.system.count);
    run.deepest_overlap = engine.tallies().deepest_overlap;
    quad const drift = exact_square_speed(engine.checkpoint(), scenery.system) / energy - 1;
    run.energy_drift = std::abs(static_cast<double>(drift));
    return run;
}

inline Run run(Scenery const& scenery, Method const method, Precision const precision,
               Start const& start, double const until, ErrorGrowth* const growth = nullptr) {
    auto const engine = make_engine(scenery.system, method, precision, start);
    return run(*engine, scenery, until, growth);
}

/// A quad run from the start with each number off by one rounding unit, up or down: what no program
/// that holds its balls in such a type can be better than, but by luck.
inline std::unique_ptr<Engine> off_by_a_unit(Scenery const& scenery, double const unit,
                                             std::uint64_t const seed) {
    auto const make = [&](auto const& origin) {
        return make_engine(scenery.system, Method::fast, Precision::quadruple, origin);
    };
    Checkpoint moved = make(scenery.start)->checkpoint();
    std::mt19937_64 random(seed);
    auto const limbs = static_cast<std::size_t>(moved.limbs);
    for (std::size_t number = 0; number < moved.records.size(); number += limbs)
        moved.records[number + limbs - 1] +=
            (uniform(random) < 0.5 ? -unit : unit) * moved.records[number];
    return make(moved);
}

/// Decimal numbers that are twice as long as quad, and fit where balls are aligned to a power of
/// two of bytes.
using Decimal = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<72>,
                                              boost::multiprecision::et_off>;

/// Whom the balls of a scene meet by the same event loop in decimal numbers, and where they are at
/// the final time. `nudge` moves each place by so much of itself first, up or down.
inline Run decimal_run(Scenery const& scenery, double const until, double const nudge,
                       std::uint64_t const seed) {
    static_assert((sizeof(Ball<Decimal>) & (sizeof(Ball<Decimal>) - 1)) == 0);
    BallState<Decimal, WalledCube<Decimal>> state(scenery.system, scenery.start,
                                                  epoch_length(scenery.system, std::sqrt(3.0)));
    std::mt19937_64 random(seed);
    for (auto& ball : state.balls)
        for (int d = 0; d < 3; ++d) {
            Decimal const unit = Decimal(uniform(random) < 0.5 ? -nudge : nudge);
            ball.point[d] += ball.point[d] * unit;
            ball.velocity[d] += ball.velocity[d] * unit;
        }
    Simulation<Decimal, WalledCube, EveryPair, CollisionTable> simulation(std::move(state));
    MeetingRecorder recorder;
    auto const observe = [&](Collision<Decimal> const& collision) {
        recorder(collision.cast<double>());
    };
    double const time = final_time * scenery.mean_free_time;
    simulation.advance({.time = time}, observe);
    Run run;
    run.places.resize(3, scenery.system.count);
    auto const& at = simulation.state();
    for (std::int32_t i = 0; i < at.count(); ++i)
        run.places.col(at.numbers[static_cast<std::size_t>(i)]) =
            at[i].position(at.clock.offset).cast<quad>();
    simulation.advance({.time = until * scenery.mean_free_time}, observe);
    run.partners = partners_of(recorder.meetings, scenery.system.count);
    return run;
}

/// Processor time of the event loop by ball and mean free time; the start is left out.  [s]
inline double cost(Scenery const& scenery, Method const method, Precision const precision) {
    constexpr double long_enough = 0.01; // [s], ten thousand times the clock's resolution
    auto const engine = make_engine(scenery.system, method, precision, scenery.start);
    double const begin = processor_seconds();
    double seconds = 0;
    do {
        engine->advance({.events = 50});
        seconds = processor_seconds() - begin;
    } while (seconds < long_enough);
    double const collisions = 2 * static_cast<double>(engine->tallies().ball_collisions);
    return seconds / std::max(collisions, 1.0);
}

/// A line's point of the chart; -1 stands for what was not measured.
struct Point {
    double cost = -1;                 // processor time by ball and mean free time  [s]
    double median = -1, largest = -1; // error of positions: median and 99 % quantile  [diameters]
    double horizon = -1;              // collisions per ball until the sequence departs
    double overlap = -1, drift = -1;  // deepest  [diameters]; of the energy, relative
    double limit = -1;                // what the horizon of this rounding unit can be at best: of
    double tangent_limit = -1;        // the exact motion of a rounded start, and by tangent space
};
constexpr std::array point_values{&Point::cost,    &Point::median,       &Point::largest,
                                  &Point::horizon, &Point::overlap,      &Point::drift,
                                  &Point::limit,   &Point::tangent_limit};

/// A line of the chart: a method with its knob.
struct Line {
    std::string method, knob;
};

inline void append(Measurement& all, Point const& point) {
    for (auto const value : point_values) all.push_back(point.*value);
}

inline Point compare(Run const& one, Run const& oracle) {
    auto const errors = distances(one.places, oracle.places);
    return {.median = quantile(errors, 0.5),
            .largest = quantile(errors, 0.99),
            .horizon = matched(oracle.partners, one.partners),
            .overlap = one.deepest_overlap,
            .drift = one.energy_drift};
}

/// Until when runs of a type are followed: far enough for all their sequences to depart.
inline double followed(StatePoint const& point, Precision const precision) {
    return 1.4 * point.limit(reference::rounding_unit(precision)) + 4;
}

/// What tangent space says of the oracle's own way.
inline ErrorGrowth growth_of(Scenery const& scenery, std::uint64_t const seed) {
    return {scenery.system, scenery.start, scenery.mean_free_path(), seed};
}

/// The engine in one type, against the oracle and against the exact motion of a rounded start.
inline Point point_of(StatePoint const& point, Scenery const& scenery, Precision const precision,
                      Run const& oracle, ErrorGrowth const& growth, std::uint64_t const seed) {
    double const until = followed(point, precision);
    double const unit = reference::rounding_unit(precision);
    Point made = compare(run(scenery, Method::fast, precision, scenery.start, until), oracle);
    made.limit =
        matched(oracle.partners, run(*off_by_a_unit(scenery, unit, seed), scenery, until).partners);
    made.tangent_limit = growth.limit(unit, seed);
    return made;
}

/// Quad in the place of a type, and decimal numbers in that of the oracle.
inline Point quad_point_of(StatePoint const& point, Scenery const& scenery,
                           std::uint64_t const seed) {
    double const until = followed(point, Precision::quadruple);
    double const unit = reference::rounding_unit(Precision::quadruple);
    Run const decimal = decimal_run(scenery, until, 0, seed);
    ErrorGrowth growth = growth_of(scenery, seed);
    Point made = compare(
        run(scenery, Method::fast, Precision::quadruple, scenery.start, until, &growth), decimal);
    made.limit = matched(decimal.partners, decimal_run(scenery, until, unit, seed).partners);
    made.tangent_limit = growth.limit(unit, seed);
    return made;
}

/// The engine's lines at a state point. The start of the table in quad alone would take seconds.
inline std::vector<std::pair<Precision, Method>> engine_lines(StatePoint const& point) {
    std::vector<std::pair<Precision, Method>> lines;
    for (Precision const precision : precisions)
        for (Method const method : methods)
            if (method != Method::table || precision != Precision::quadruple || point.count < 1000)
                lines.emplace_back(precision, method);
    return lines;
}

/// All methods go the same way to the last bit, so the errors are those of `fast`.
inline Measurement measure_engine(StatePoint const& point, std::uint64_t const seed) {
    Scenery const place = scenery(point, seed);
    Precision const finest = point.count < 1000 ? Precision::extended : Precision::double_;
    ErrorGrowth growth = growth_of(place, seed);
    Run const oracle = run(place, Method::fast, Precision::quadruple, place.start,
                           followed(point, finest), &growth);
    std::map<Precision, Point> of_type;
    for (Precision const precision : precisions)
        if (precision <= finest)
            of_type[precision] = point_of(point, place, precision, oracle, growth, seed);
    if (point.with_decimal) of_type[Precision::quadruple] = quad_point_of(point, place, seed);
    Measurement values;
    for (auto const& [precision, method] : engine_lines(point)) {
        Point made = of_type[precision];
        made.cost = cost(place, method, precision);
        append(values, made);
    }
    return values;
}

} // namespace clack::validation::work_precision
