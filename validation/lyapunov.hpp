#pragma once
// How fast two runs that begin nearly alike part: state points, and two ways to measure it.

#include "observables/tangent_vector.hpp"
#include "reference/lyapunov_exponent.hpp"
#include "validation/exact_places.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/lattice_start.hpp"
#include "validation/mutants/engine_maker.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace clack::validation::lyapunov {

constexpr double equilibration = 30; // collisions per ball
constexpr double alignment = 30;     // the same, until a vector has turned to where it grows most

/// What is measured at a point. The formula was fitted to measurements at some, and is judged at
/// others that it has not seen.
enum class Part {
    fitted,   // the exponent in tangent space
    held_out, // the same
    twins     // that of twin runs, and of the tangent vector along them
};

/// A fluid in a cube, and how long a tangent vector is carried along it; twins part when they do.
struct StatePoint {
    Boundary boundary;
    double packing_fraction;
    std::int64_t count;
    double collisions_per_ball;
    int replicates;
    Part part = Part::fitted;

    char const* boundary_name() const { return boundary == Boundary::walls ? "walls" : "periodic"; }
    System system() const {
        double const volume =
            static_cast<double>(count) * std::numbers::pi / (6 * packing_fraction);
        return {.boundary = boundary, .side = std::cbrt(volume), .count = count};
    }
    std::string text() const {
        return fmt::format("{} boundary={} packing_fraction={} count={} collisions_per_ball={}",
                           part == Part::twins ? "twins" : "tangent", boundary_name(),
                           packing_fraction, count, collisions_per_ball);
    }
};

/// Dilute to nearly freezing. The shorter runs of more balls hold as many collisions. Those that
/// are held out have other numbers and packing fractions than the fit, of both inside its range;
/// where quad runs are compared with their twins, the more collisions part them the fewer are
/// needed.
inline std::vector<StatePoint> state_points(Profile const profile) {
    bool const full = profile == Profile::full;
    double const longer = full ? 40 : 1;
    int const replicates = full ? 8 : 2; // at points that are shown but not judged
    std::vector<StatePoint> points;
    for (Boundary const boundary : {Boundary::walls, Boundary::periodic}) {
        auto const add = [&](double packing_fraction, std::int64_t count, double collisions,
                             int times, Part part) {
            points.push_back({boundary, packing_fraction, count, collisions, times, part});
        };
        for (auto const& [packing_fraction, count] :
             {std::pair{0.003, 300}, {0.025, 60}, {0.1, 500}, {0.25, 60}, {0.35, 200}, {0.43, 400}})
            add(packing_fraction, count, longer * 4e4 / count, 8, Part::held_out);
        for (double const packing_fraction : {0.001, 0.01, 0.05, 0.2, 0.3, 0.4, 0.45})
            for (auto const& [count, collisions] :
                 {std::pair{27, 600.0}, {100, 400.0}, {1000, 80.0}})
                // So few would stay a crystal, or meet their own images.
                if (count > 27 || (packing_fraction <= 0.4 && boundary == Boundary::walls))
                    add(packing_fraction, count, longer * collisions, replicates, Part::fitted);
        for (auto const& [packing_fraction, pairs] : {std::pair{0.05, 8}, {0.2, 6}, {0.4, 3}})
            add(packing_fraction, 100, 0, (full ? 10 : 1) * pairs, Part::twins);
    }
    return points;
}

inline std::uint64_t collisions_of(StatePoint const& point, double const per_ball) {
    return static_cast<std::uint64_t>(per_ball * static_cast<double>(point.count) / 2);
}

/// Balls of the state point at equilibrium, their clock at 0; and their collision rate.
struct Fluid {
    std::unique_ptr<Engine> engine;
    double rate; // collisions of a ball in unit time
};

inline Fluid fluid(StatePoint const& point, std::uint64_t const seed) {
    Scene scene;
    scene.system = point.system();
    // A random start of few balls would jam where a lattice has melted long before the end.
    scene.arrangement = point.packing_fraction < 0.45 ? Arrangement::random : Arrangement::fcc;
    scene.seed = seed;
    auto engine = make_true_engine(scene);
    engine->advance({.ball_collisions = collisions_of(point, equilibration)});
    double const rate = equilibration / engine->time();
    engine->start_clock();
    return {std::move(engine), rate};
}

/// Differences that are as likely in any direction.
inline Eigen::Matrix3Xd random_differences(std::int64_t const count, std::uint64_t const seed) {
    std::mt19937_64 random(seed);
    Eigen::Matrix3Xd all(3, count);
    for (Eigen::Index k = 0; k < all.size(); ++k) all(k) = uniform(random, -1, 1);
    return all;
}

/// In tangent space: the exponent over the collision rate, from one long run.
inline Measurement measure_tangent(StatePoint const& point, std::uint64_t const seed) {
    auto const [engine, rate] = fluid(point, seed);
    TangentVector vector(engine->system(), random_differences(point.count, seed),
                         random_differences(point.count, seed + 1));
    double gained = 0, collisions = 0;
    for (double per_ball = 1; per_ball <= alignment + point.collisions_per_ball; ++per_ball) {
        engine->advance({.ball_collisions = collisions_of(point, per_ball)}, &vector);
        vector.move_to(engine->time());
        double const logarithm = vector.normalise(1 / rate);
        if (per_ball <= alignment) continue;
        gained += logarithm;
        ++collisions;
    }
    return {gained / collisions};
}

/// A run in quad, its twin, and the tangent vector that points from one to the other.
class Twins {
public:
    Twins(Fluid const& fluid, std::uint64_t const seed)
        : system_(fluid.engine->system()), one_(quad_engine(start_of(*fluid.engine))),
          vector_(system_, nudge * random_differences(system_.count, seed),
                  Eigen::Matrix3Xd::Zero(3, system_.count)) {
        Checkpoint moved = one_->checkpoint();
        displace(moved, vector_.places());
        other_ = quad_engine(moved);
    }

    /// Logarithms of the distance of the places at a time: of the two runs, and of the vector.
    std::pair<double, double> apart(double const time) {
        one_->advance({.time = time}, &vector_);
        other_->advance({.time = time});
        vector_.move_to(time);
        double sum = 0;
        for (double const x : distances(exact_places(one_->checkpoint(), system_, time),
                                        exact_places(other_->checkpoint(), system_, time)))
            sum += x * x;
        return {std::log(sum) / 2, std::log(vector_.places().norm())};
    }
    double collisions_per_ball() const {
        return 2 * static_cast<double>(one_->tallies().ball_collisions) /
               static_cast<double>(system_.count);
    }

    static constexpr double nudge = 1e-26; // [diameters]: far above the rounding of quad
    static constexpr double last = 1e-7;   // and far below what curves

private:
    template <class Origin> std::unique_ptr<Engine> quad_engine(Origin const& origin) const {
        return make_engine(system_, Method::automatic, Precision::quadruple, origin);
    }
    static Start start_of(Engine const& engine) {
        Snapshot const shot = engine.snapshot();
        return {shot.positions, shot.velocities};
    }

    System system_;
    std::unique_ptr<Engine> one_, other_;
    TangentVector vector_;
};

/// By twin runs, and by the tangent vector on the same way: the exponents over the collision rate
/// between a quarter of the way from the first distance to the last and its end.
inline Measurement measure_twins(StatePoint const& point, std::uint64_t const seed) {
    Fluid const start = fluid(point, seed);
    Twins twins(start, seed);
    double const way = std::log(Twins::last / Twins::nudge);
    double const time =
        way / (reference::lyapunov_exponent_per_collision(point.system()) * start.rate);
    auto const [first, first_vector] = twins.apart(time / 4);
    double const before = twins.collisions_per_ball();
    auto const [last, last_vector] = twins.apart(time);
    double const collisions = twins.collisions_per_ball() - before;
    return {(last - first) / collisions, (last_vector - first_vector) / collisions};
}

inline Measurement measure(StatePoint const& point, std::uint64_t const seed) {
    return point.part == Part::twins ? measure_twins(point, seed) : measure_tangent(point, seed);
}

constexpr double twin_margin = 1e-3, formula_margin = 0.06;

/// What is known of a point beside what it should be: the formula's exponent, and that of the
/// tangent vector for its twins.
inline void enter(Ledger& ledger, StatePoint const& point,
                  std::vector<Measurement> const& replicates) {
    double const formula = reference::lyapunov_exponent_per_collision(point.system());
    std::vector<std::string> const state{point.boundary_name(), cell(point.packing_fraction),
                                         cell(point.count)};
    Comparison const exponent{.measured = mean_of(replicates, 0),
                              .reference = formula,
                              .margin = formula_margin * formula};
    bool const twins = point.part == Part::twins;
    Quantity const which =
        twins ? Quantity{"twins", "$\\lambda$, twins"} : Quantity{"exponent", "$\\lambda$"};
    if (point.part == Part::held_out)
        ledger.compare(state, which, exponent);
    else
        ledger.guide(state, which, exponent);
    if (!twins) return;
    auto const ratio = [](Measurement const& m) { return m[0] / m[1]; };
    ledger.compare(state, {"twins_over_tangent", "$\\lambda$, twins; tangent"},
                   {.measured = mean_of(replicates, ratio), .reference = 1, .margin = twin_margin});
}

} // namespace clack::validation::lyapunov
