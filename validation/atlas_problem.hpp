#pragma once
// A scene of the failure atlas at one degree of difficulty, and what a method makes of it.

#include "simulation/engine.hpp"
#include "simulation/epoch.hpp"
#include "state/errors.hpp"
#include "validation/lattice_start.hpp"

#include <array>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace clack::validation::atlas {

/// The balls at one moment.
struct Frame {
    Eigen::Matrix3Xd places, velocities;
};

/// A scene. What can go wrong in it must go wrong within its time.
struct Problem {
    System system;
    Start start;
    std::vector<double> times{};          // when the balls are looked at, since the start; evenly
    std::array<bool, 3> axes{1, 1, 1};    // along which the rounding of a start can point
    double clock = 0;                     // what the clock says at the start
    bool turns_round = false;             // half way all velocities are reversed
    double long_collisions = 0;           // how many there will be, where they are very many: the
                                          // balls are then looked at after equal numbers of them
    bool has_reference = true;            // or it is too long for one: the invariants are left
    bool fast_alone = false;              // too long for all methods but the fast one
    std::function<Frame(double)> exact{}; // closed form where there is one

    double speed() const { return std::sqrt(start.velocities.colwise().squaredNorm().mean()); }
    /// What takes more events in one call, or longer, hangs.
    std::uint64_t events_max() const {
        return static_cast<std::uint64_t>(2e6 + 20 * long_collisions);
    }
    /// Where an engine stops for its next look at the balls.
    Goal goal(std::size_t look, double zero) const {
        if (long_collisions > 0) {
            double const share = static_cast<double>(look + 1) / static_cast<double>(times.size());
            return {.ball_collisions = static_cast<std::uint64_t>(share * long_collisions),
                    .events = events_max()};
        }
        return {.time = zero + times[look], .events = events_max()};
    }
    unsigned seconds_max() const { return static_cast<unsigned>(30 + 1e-5 * long_collisions); }
    double fastest() const { return start.velocities.colwise().norm().maxCoeff(); }
};

/// When the balls are looked at: evenly, and not at round times, at which a round start makes balls
/// and walls meet.
inline std::vector<double> looks(double const time, int const count = 8) {
    constexpr double not_round = 0.98171;
    std::vector<double> times;
    for (int k = 1; k <= count; ++k) times.push_back(not_round * time * k / count);
    return times;
}

/// Two balls that meet.
using Meeting = std::pair<std::int64_t, std::int64_t>;

/// The balls that each ball meets, in their order: the order of meetings that have no ball in
/// common does not matter.
using Partners = std::vector<std::vector<std::int64_t>>;

inline Partners partners_of(std::vector<Meeting> const& meetings, std::int64_t count) {
    Partners partners(static_cast<std::size_t>(count));
    for (auto const& [i, j] : meetings) {
        partners[static_cast<std::size_t>(i)].push_back(j);
        partners[static_cast<std::size_t>(j)].push_back(i);
    }
    return partners;
}

/// How a run ended. The engine names the law that it saw broken.
enum class End { reached, lost, overlap, apart, energy, hang, crash };

/// What a method made of a problem: as many frames as it got to.
struct Trace {
    std::vector<Frame> frames{};
    std::vector<Meeting> meetings{};
    double collisions_per_ball = 0; // with balls and walls
    double collisions = 0;          // between balls, and the deepest overlap at one, as the engine
    double deepest_overlap = 0;     // has counted them  [diameters]
    End end = End::reached;
};

class TraceRecorder final : public CollisionObserver {
public:
    TraceRecorder(Trace& trace, Problem const& problem)
        : trace_(trace), share_(1 / static_cast<double>(problem.system.count)),
          keeps_meetings_(problem.has_reference) {}
    void operator()(Collision<double> const& collision) override {
        bool const wall = collision.kind == CollisionKind::wall;
        trace_.collisions_per_ball += wall ? share_ : 2 * share_;
        if (!wall && keeps_meetings_)
            trace_.meetings.emplace_back(collision.first, collision.second);
    }

private:
    Trace& trace_;
    double share_;
    bool keeps_meetings_;
};

/// Which of its laws an engine found broken: the line begins with it.
inline End broken_law(std::string_view const line) {
    auto const says = [&](char const* words) { return line.find(words) != std::string_view::npos; };
    if (says("overlap")) return End::overlap;
    if (says("apart")) return End::apart;
    if (says("energy")) return End::energy;
    return End::hang; // time that stands still, or runs backwards
}

/// An error of each coordinate of a start, uniform and as large as rounding may make it; a negative
/// roundoff turns all errors round.
struct Shake {
    double roundoff = 0;
    std::uint64_t seed = 0;

    /// Balls that touch must not overlap when they are shaken: they are smaller by as much.
    System shrunk(System system) const {
        system.diameter -= 4 * std::abs(roundoff) * system.side;
        return system;
    }
};

/// A start as an engine of any precision goes on from it. The errors of `shake` are limbs of their
/// own, so that they may be far smaller than a double can tell.
inline Checkpoint checkpoint_of(Problem const& problem, Start const& start, double const clock,
                                Precision const precision, Shake const& shake = {}) {
    Checkpoint kept;
    kept.limbs = precision == Precision::quadruple ? limb_count<quad> : 1;
    kept.epoch_length = epoch_length(problem.system, problem.speed());
    double const epochs = std::floor(clock / kept.epoch_length);
    kept.epoch = static_cast<std::int64_t>(epochs);
    auto const add = [&](std::vector<double>& limbs, double value, double error) {
        limbs.push_back(value);
        for (int limb = 1; limb < kept.limbs; ++limb) limbs.push_back(limb == 1 ? error : 0);
    };
    double const offset = clock - epochs * kept.epoch_length;
    add(kept.offset, offset, 0);
    kept.images = Eigen::Matrix3Xi::Zero(3, start.positions.cols());
    std::mt19937_64 random(shake.seed);
    for (Eigen::Index i = 0; i < start.positions.cols(); ++i) {
        Eigen::Vector3d const x = start.positions.col(i), v = start.velocities.col(i);
        auto const error = [&](int d, double size) {
            double const way = uniform(random, -1, 1);
            return problem.axes[static_cast<std::size_t>(d)] ? shake.roundoff * size * way : 0;
        };
        for (int d = 0; d < 3; ++d) add(kept.records, x[d], error(d, problem.system.side));
        for (int d = 0; d < 3; ++d) add(kept.records, v[d], error(d, v.norm()));
        add(kept.records, offset, 0);
    }
    return kept;
}

using Maker = std::function<std::unique_ptr<Engine>(System const&, Checkpoint const&)>;

inline Frame frame_of(Engine const& engine) {
    Snapshot const shot = engine.snapshot();
    return {shot.positions, shot.velocities};
}

/// Flies a problem by an engine.
inline Trace fly(Problem const& problem, Maker const& make, Precision const precision,
                 Shake const& shake = {}) {
    Trace trace;
    TraceRecorder recorder(trace, problem);
    try {
        System const system = shake.shrunk(problem.system);
        double zero = problem.clock;
        auto engine = make(system, checkpoint_of(problem, problem.start, zero, precision, shake));
        for (std::size_t k = 0; k < problem.times.size(); ++k) {
            Stop const stop = engine->advance(problem.goal(k, zero), &recorder);
            trace.collisions = static_cast<double>(engine->tallies().ball_collisions);
            trace.deepest_overlap = engine->tallies().deepest_overlap;
            if (stop == Stop::events) {
                trace.end = End::hang;
                return trace;
            }
            Frame const frame = frame_of(*engine);
            trace.frames.push_back(frame);
            if (!problem.turns_round || 2 * (k + 1) != problem.times.size()) continue;
            // Half way: rounded to double, whatever the precision.
            zero = -problem.times[k];
            Start const back{frame.places, -frame.velocities};
            engine = make(system, checkpoint_of(problem, back, 0, precision,
                                                {shake.roundoff, shake.seed + 1}));
        }
    } catch (LawBroken const& broken) {
        trace.end = broken_law(broken.what());
    }
    return trace;
}

} // namespace clack::validation::atlas
