#pragma once
// What each ingredient costs a collision, and what `auto` chooses: state points and measurements.

#include "neighbours/cell_grid.hpp"
#include "observables/overlap.hpp"
#include "scheduling/calendar.hpp"
#include "simulation/engine_of.hpp"
#include "simulation/epoch.hpp"
#include "simulation/model_choice.hpp"
#include "state/errors.hpp"
#include "validation/constant_field.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/ingredients.hpp"
#include "validation/lattice_start.hpp"
#include "validation/mutants/engine_maker.hpp"
#include "validation/observed_runs.hpp"
#include "validation/sized_balls.hpp"
#include "validation/timing.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <string>

namespace clack::validation::price {

/// Balls in equilibrium; by the table where they are few. In a periodic cube none begins on the
/// edge of a cell, where two balls that mirror each other would come back to.
inline Start equilibrated(System const& system, std::uint64_t const seed) {
    Start lattice = lattice_start(system, seed);
    if (system.boundary == Boundary::periodic)
        lattice.positions.colwise() += Eigen::Vector3d{0.1, 0.2, 0.3} * system.side;
    constexpr std::int64_t few = 128;
    constexpr std::uint64_t collisions_per_ball = 10;
    auto const engine =
        make_true_method(system, system.count > few ? Method::fast : Method::table, lattice);
    engine->advance(
        {.ball_collisions = collisions_per_ball * static_cast<std::uint64_t>(system.count)});
    return start_of(*engine);
}

/// How many times as long as the first the second takes. They go in turn, first, second, second,
/// first, so that neither always has the processor when it has just been given back.
inline double times_as_long(TimedRun& first, TimedRun& second, std::uint64_t const slice,
                            int const rounds) {
    std::vector<double> ratios;
    for (int round = 0; round < rounds; ++round) {
        double const before = first.go(slice), between = second.go(slice) + second.go(slice);
        ratios.push_back(between / (before + first.go(slice)));
    }
    return median_of(ratios).value;
}

// --- ingredients

double const speed = std::sqrt(3.0); // about that of the start, root mean square

/// The smallest model between walls, or that with something more.
template <class Real = double, template <class> class Model = ElasticBalls,
          template <class> class Container = WalledCube>
std::unique_ptr<Engine> engine_with(System const& system, Start const& start) {
    BallState<Real, Container<Real>> state(system, start, epoch_length(system, speed));
    for (Ball<Real>& ball : state.balls) ball.note = 0; // no heavier, no larger
    return std::make_unique<EngineOf<Simulation<Real, Container, CellGrid, Calendar, Model>>>(
        std::move(state), ModelDescription{});
}

enum class Sameness {
    bits,            // the hash of the plain run
    first_collisions // other arithmetic: the same partners at first
};

/// Something that a scene may ask for, neutral in the scene at hand.
struct Ingredient {
    char const* name;
    std::function<TimedRun(System const&, Start const&)> run;
    Sameness sameness = Sameness::bits;
    std::uint64_t slowness = 1; // about how many times as long as the plain run it takes, if many
};

template <class Real = double, template <class> class Model = ElasticBalls,
          template <class> class Container = WalledCube>
TimedRun run_with(System const& system, Start const& start) {
    return {engine_with<Real, Model, Container>(system, start)};
}
inline TimedRun hashed_run(System const& system, Start const& start) {
    TimedRun run{engine_with(system, start)};
    run.engine->hash_collisions();
    return run;
}
inline TimedRun kept_run(System const& system, Start const& start) {
    return {engine_with(system, start), std::make_unique<EventKeeper>()};
}
inline TimedRun checked_run(System const& system, Start const& start) {
    return {engine_with(system, start),
            std::make_unique<EventChecker>(system, start, epoch_length(system, speed))};
}
template <TimedRun (*watched)(std::unique_ptr<Engine>)>
TimedRun watched_run(System const& system, Start const& start) {
    return watched(engine_with(system, start));
}

inline std::vector<Ingredient> const& ingredients() {
    using enum Sameness;
    static std::vector<Ingredient> const all{
        {"periodic code", run_with<double, WrappedPairs>},
        {"a mass for each ball", run_with<double, MassOfEach>},
        {"a diameter for each ball", run_with<double, DiameterOfEach>},
        {"a restitution", run_with<double, Restitution>},
        {"a constant field", run_with<double, FallingBalls, RisingCube>},
        {"growing balls", run_with<double, UngrownBalls>, first_collisions},
        {"the hash of all events", hashed_run},
        {"records of all events", kept_run},
        {"laws checked at all events", checked_run},
        {"free flights", watched_run<with_flights>},
        {"Helfand's moments", watched_run<with_moments>},
        {"a tangent vector", watched_run<with_tangent>},
        {"looks: density profile", watched_run<with_profile>},
        {"looks: self-correlation", watched_run<with_correlation>},
        {"looks: pair correlation", watched_run<with_pairs>},
        {"looks: structure factor", watched_run<with_waves>},
        {"looks: bond order", watched_run<with_bonds>},
        {"float", run_with<float>, first_collisions},
        {"long double", run_with<long double>, first_collisions, 4},
        {"quad", run_with<quad>, first_collisions, 20}};
    return all;
}

/// Balls between walls that all ingredients are added to.
struct Plain {
    std::int64_t count;
    double packing_fraction;
    std::uint64_t slice; // collisions
    int rounds, replicates;

    std::string text() const {
        return fmt::format("ingredients count={} packing_fraction={} slice={} rounds={}", count,
                           packing_fraction, slice, rounds);
    }
    System system() const { return cube(Boundary::walls, count, packing_fraction); }
};
inline Plain plain(Profile const profile) {
    if (profile == Profile::quick) return {1'000, 0.2, 500, 25, 5};
    return {1'000, 0.2, 5'000, 51, 9};
}

/// Whom each ball meets, in their order: balls, and walls as negative numbers.
struct Partners final : CollisionObserver {
    std::vector<std::vector<std::int64_t>> of_ball;

    explicit Partners(std::int64_t const count) : of_ball(static_cast<std::size_t>(count)) {}
    void operator()(Collision<double> const& event) override {
        bool const wall = event.kind == CollisionKind::wall;
        of_ball[static_cast<std::size_t>(event.first)].push_back(wall ? -1 - event.second
                                                                      : event.second);
        if (!wall) of_ball[static_cast<std::size_t>(event.second)].push_back(event.first);
    }
};

/// Meetings at the beginning that two runs have in common, mean over the balls.
inline double in_common(Partners const& one, Partners const& other) {
    double sum = 0;
    for (std::size_t ball = 0; ball < one.of_ball.size(); ++ball) {
        auto const &a = one.of_ball[ball], &b = other.of_ball[ball];
        sum += static_cast<double>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first -
                                   a.begin());
    }
    return sum / static_cast<double>(one.of_ball.size());
}

/// That an ingredient moves the balls as they go without it: what it costs is then the cost of the
/// same work. Returns the meetings of a ball that the runs have in common, infinity for all.
inline double require_neutral(Ingredient const& ingredient, System const& system,
                              Start const& start) {
    constexpr std::uint64_t collisions_per_ball = 5;
    Goal const goal{.ball_collisions =
                        collisions_per_ball * static_cast<std::uint64_t>(system.count)};
    TimedRun const plain = run_with<>(system, start), with = ingredient.run(system, start);
    Partners of_plain(system.count), of_with(system.count);
    for (TimedRun const* const run : {&plain, &with}) run->engine->hash_collisions();
    plain.engine->advance(goal, &of_plain);
    with.engine->advance(goal, &of_with);
    double const common = in_common(of_plain, of_with);
    bool const same = plain.engine->hash() == with.engine->hash();
    if (ingredient.sameness == Sameness::bits ? !same : common < 1)
        throw LawBroken(fmt::format("with {} the balls go another way after {:.1f} collisions each",
                                    ingredient.name, common));
    return same ? infinity<double> : common;
}

/// For each ingredient: its cost over the plain run's.
inline Measurement measure(Plain const& plain, std::uint64_t const seed) {
    System const system = plain.system();
    Start const start = equilibrated(system, seed);
    Measurement all;
    for (Ingredient const& ingredient : ingredients()) {
        TimedRun without = run_with<>(system, start), with = ingredient.run(system, start);
        all.push_back(
            times_as_long(without, with, plain.slice / ingredient.slowness, plain.rounds));
        require_neutral(ingredient, system, start);
    }
    return all;
}

// --- what `auto` chooses

constexpr std::array methods{Method::table, Method::heap, Method::fast};

/// Balls that all methods move.
struct Point {
    Boundary boundary;
    std::int64_t count;
    double packing_fraction;
    int rounds, replicates;

    std::string text() const {
        return fmt::format("auto {} count={} packing_fraction={} rounds={}", name_of(boundary),
                           count, packing_fraction, rounds);
    }
    std::vector<std::string> state() const {
        return {name_of(boundary), cell(count), cell(packing_fraction)};
    }
    System system() const { return cube(boundary, count, packing_fraction); }
    /// Whether that many balls have room on the lattice of the start.
    bool has_room() const {
        if (system().accessible_side() <= 0) return false;
        return deepest_overlap(system(), lattice_start(system(), 0).positions).depth == 0;
    }
    /// Timed at a time: fewer where all pairs are looked at, above all through all images.
    std::uint64_t slice(Method const method) const {
        bool const images = touches_through_several_images(system());
        double const most = images ? 8e3 : method == Method::table ? 2e5 : 1e9;
        return static_cast<std::uint64_t>(
            std::clamp(most / static_cast<double>(count), 100.0, 500.0));
    }
};

inline std::vector<Point> points(Profile const profile) {
    bool const full = profile == Profile::full;
    std::vector<std::int64_t> counts{2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 100, 200, 500, 2'000};
    if (full) counts.insert(counts.end(), {8'000, 32'000});
    std::vector<Point> all;
    for (Boundary const boundary : {Boundary::walls, Boundary::periodic})
        for (double const packing_fraction : {0.01, 0.05, 0.2, 0.4, 0.49})
            for (std::int64_t const count : counts)
                all.push_back({boundary, count, packing_fraction, full ? 15 : 3, full ? 9 : 5});
    std::erase_if(all, [](Point const& point) { return !point.has_room(); });
    return all;
}

/// The rate of `auto` over that of each method; infinity where `auto` is that very method.
inline Measurement measure(Point const& point, std::uint64_t const seed,
                           MethodMaker const& make = make_true_method) {
    System const system = point.system();
    Start const start = equilibrated(system, seed);
    Measurement all;
    for (Method const method : methods) {
        TimedRun chosen{make(system, Method::automatic, start)}, run{make(system, method, start)};
        ModelDescription const one = run.engine->model(), other = chosen.engine->model();
        bool const same = one.search == other.search && one.queue == other.queue;
        all.push_back(same ? infinity<double>
                           : times_as_long(chosen, run, point.slice(method), point.rounds));
    }
    return all;
}

constexpr double least = 0.9; // of the rate of each method

/// `auto` beside each other method at one point.
inline void enter(Ledger& ledger, Point const& point, std::vector<Measurement> const& replicates) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
        if (replicates.front()[m] == infinity<double>) continue;
        ledger.compare(point.state(),
                       {fmt::format("auto_over_{}", name_of(methods[m])), name_of(methods[m])},
                       {.measured = median_of(replicates, [=](auto const& r) { return r[m]; }),
                        .reference = least,
                        .asks = Asks::whether_at_least});
    }
}

} // namespace clack::validation::price
