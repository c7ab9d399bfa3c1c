#pragma once
// What a long run must keep: state points, one measurement, and the bounds of rounding.

#include "simulation/epoch.hpp"
#include "state/errors.hpp"
#include "validation/harness/experiment.hpp"
#include "validation/mutants/engine_maker.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <vector>

namespace clack::validation::conservation {

struct StatePoint {
    Boundary boundary;
    double packing_fraction;
    std::int64_t count;
    double collisions_per_ball;
    static constexpr int replicates = 1;

    char const* boundary_name() const { return boundary == Boundary::walls ? "walls" : "periodic"; }
    std::string text() const {
        return fmt::format("boundary={} packing_fraction={} count={} collisions_per_ball={}",
                           boundary_name(), packing_fraction, count, collisions_per_ball);
    }
    Scene scene(std::uint64_t seed) const {
        return parse_scene(
            fmt::format("[container]\nboundary = \"{}\"\npacking_fraction = {}\n"
                        "[balls]\ncount = {}\narrangement = \"random\"\n"
                        "[velocities]\ndistribution = \"maxwell\"\ntemperature = 1.0\n"
                        "[run]\nseed = {}\ncollisions_per_ball = {}\n",
                        boundary_name(), packing_fraction, count, seed & 0x7fffffffu,
                        collisions_per_ball),
            "conservation");
    }
};

inline std::vector<StatePoint> state_points(Profile const profile) {
    double const longer = profile == Profile::quick ? 1 : 30;
    std::vector<StatePoint> points;
    for (Boundary const boundary : {Boundary::walls, Boundary::periodic})
        for (double const packing_fraction : {0.05, 0.3, 0.45})
            points.push_back({boundary, packing_fraction, 256, longer * 8192});
    return points;
}

/// What a run has come to at one moment.
struct Moment {
    double collisions_per_ball;
    double energy_drift;    // relative
    double momentum;        // its change over m v_rms sqrt(n); 0 between walls, which take it up
    double deepest_overlap; // [diameters]
    double wall_distance;   // error of a centre's distance from the wall it hits  [diameters]
};

/// How far from its wall a ball turns back, beside half a diameter.
class WallDistance final : public CollisionObserver {
public:
    explicit WallDistance(System const& system) : system_(system) {}

    void operator()(Collision<double> const& collision) override {
        if (collision.kind != CollisionKind::wall) return;
        double const place = collision.position[collision.second / 2];
        double const distance = collision.second % 2 == 0 ? place : system_.side - place;
        double const error = std::abs(distance / system_.diameter - 0.5);
        if (!(error <= largest_)) largest_ = error;
    }
    double largest() const { return largest_; }

private:
    System system_;
    double largest_ = 0;
};

/// The moments of one run, at collisions per ball that double from 1 on.
inline std::vector<Moment> measure(StatePoint const& point, std::uint64_t seed,
                                   EngineMaker const& make = make_true_engine) {
    auto const engine = make(point.scene(seed));
    double const energy = engine->kinetic_energy();
    Eigen::Vector3d const momentum = engine->momentum();
    double const unit = std::sqrt(2 * energy * engine->system().mass); // m v_rms sqrt(n)
    WallDistance walls(engine->system());
    std::vector<Moment> moments;
    for (double collisions = 1; collisions <= point.collisions_per_ball; collisions *= 2) {
        auto const goal = collisions * static_cast<double>(point.count) / 2;
        if (engine->advance({.ball_collisions = static_cast<std::uint64_t>(goal)}, &walls) ==
            Stop::never)
            throw LawBroken(
                fmt::format("no ball will collide any more at t = {:.17g}", engine->time()));
        double const change = (engine->momentum() - momentum).norm() / unit;
        moments.push_back({collisions, engine->kinetic_energy() / energy - 1,
                           point.boundary == Boundary::walls ? 0 : change,
                           engine->tallies().deepest_overlap, walls.largest()});
    }
    return moments;
}

constexpr double roundoff = std::numeric_limits<double>::epsilon() / 2;

/// Each collision rounds the velocities of two balls a few times, up or down: the error of the sum
/// wanders as the square root of their number. Measured: a quarter of a rounding times that root.
/// An error of one sign would show: a tenth of a rounding a collision is beyond the bound from two
/// thousand collisions a ball on.
inline double drift_bound(double collisions_per_ball) {
    return 4 * roundoff * (2 + std::sqrt(collisions_per_ball));
}

/// A contact is as deep as places and times are rounded: no deeper in a long run than in a short
/// one, but for the luck of more draws.
inline double overlap_bound(System const& system) {
    double const speed = std::sqrt(3.0);
    double const flight = speed * epoch_length(system, speed);
    return 16 * roundoff * (system.side + flight) / system.diameter;
}

/// A wall is a number: the distance from it is rounded when it is set and when it is measured.
inline double wall_bound(System const& system) {
    return 4 * roundoff * system.side / system.diameter;
}

/// Whether a moment keeps all laws.
inline bool holds(Moment const& moment, System const& system) {
    double const drift = drift_bound(moment.collisions_per_ball);
    return std::abs(moment.energy_drift) <= drift && moment.momentum <= drift &&
           moment.deepest_overlap <= overlap_bound(system) &&
           moment.wall_distance <= wall_bound(system);
}

} // namespace clack::validation::conservation
