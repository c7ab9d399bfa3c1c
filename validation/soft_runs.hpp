#pragma once
// Segments of a run of hard balls, and the same with soft balls: by LAMMPS, and by the engine with
// a diameter that yields.

#include "neighbours/every_pair.hpp"
#include "reference/equation_of_state.hpp"
#include "reference/finite_size.hpp"
#include "reference/lammps.hpp"
#include "reference/lammps_files.hpp"
#include "reference/soft_balls.hpp"
#include "scheduling/binary_heap.hpp"
#include "simulation/epoch.hpp"
#include "simulation/simulation.hpp"
#include "validation/mutants/engine_maker.hpp"
#include "validation/soft_segments.hpp"
#include "validation/softened_balls.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace clack::validation {

/// Balls of a system at equilibrium.
///   collisions_per_ball   on the way there
inline Start equilibrated(System const& system, double const collisions_per_ball,
                          std::uint64_t const seed) {
    Scene scene;
    scene.system = system;
    scene.arrangement = Arrangement::random;
    scene.seed = seed;
    auto const engine = make_true_engine(scene);
    double const rate = reference::collision_rate(
        reference::modified_klm(system.packing_fraction()) - 1, system.degrees_of_freedom());
    engine->advance({.time = collisions_per_ball / rate});
    Snapshot const shot = engine->snapshot();
    return {shot.positions, shot.velocities};
}

/// The engine that is put to the test, from a start at time 0.
using SegmentEngine = std::function<std::unique_ptr<Engine>(System const&, Start const&)>;

inline std::unique_ptr<Engine> true_segment_engine(System const& system, Start const& start) {
    return make_engine(system, Method::automatic, Precision::double_, start);
}

/// Segments one after the other, each started afresh from the places where the one before it ended.
inline std::vector<Segment> segments_from(System const& system, Start start, double const time,
                                          int const count, SegmentEngine const& make) {
    std::vector<Segment> segments;
    for (int k = 0; k < count; ++k) {
        segments.push_back(fly(*make(system, start), time));
        start = {segments.back().end.positions, segments.back().end.velocities};
    }
    return segments;
}

/// The same segment with hard balls whose diameter yields as that of soft ones does.
template <template <class> class Model = SoftenedBalls>
Segment softened(System const& system, Segment const& segment, double const stiffness,
                 double const steps_per_contact) {
    using Softened = Simulation<double, WalledCube, EveryPair, BinaryHeap, Model>;
    double const speed = std::sqrt(segment.start.velocities.colwise().squaredNorm().mean());
    Model<double> const model(system,
                              reference::stepped_contact_duration(stiffness, steps_per_contact));
    Softened simulation(
        BallState<double, WalledCube<double>>(system, segment.start, epoch_length(system, speed)),
        model);
    MeetingRecorder recorder;
    simulation.advance({.time = segment.time},
                       [&](Collision<double> const& collision) { recorder(collision); });
    return {segment.start, segment.time, recorder.meetings, simulation.state().snapshot()};
}

/// Who is compared with LAMMPS: the engine, or mutants of it that must not pass.
struct Engines {
    SegmentEngine hard = true_segment_engine;
    std::function<Segment(System const&, Segment const&, double, double)> yielding =
        softened<SoftenedBalls>;
};

/// How LAMMPS goes through the segments: one job for each stiffness and segment.
struct SoftRuns {
    System system;
    std::vector<double> stiffnesses;
    double steps_per_contact;
    double looks_per_contact; // at the pairs that touch; 0: at the beginning and the end only

    static std::string name(std::size_t stiffness, std::size_t segment) {
        return fmt::format("{}_{}", stiffness, segment);
    }
    static std::string data(std::size_t segment) { return fmt::format("{}.data", segment); }

    /// What a job of lammps_cube.in needs. Steps end exactly with the segment.
    reference::LammpsJob job(std::size_t stiffness, std::size_t segment, double time) const {
        double const k = stiffnesses[stiffness];
        double const contacts = time / reference::contact_duration(k);
        auto const steps = static_cast<std::int64_t>(std::ceil(contacts * steps_per_contact));
        auto const look = looks_per_contact > 0
                              ? static_cast<std::int64_t>(steps_per_contact / looks_per_contact)
                              : steps;
        return {{"data", data(segment)},
                {"side", fmt::format("{:.17g}", system.side)},
                {"k", fmt::format("{:.17g}", k)},
                {"kw", fmt::format("{:.17g}", 2 * k)},
                {"dt", fmt::format("{:.17g}", time / static_cast<double>(steps))},
                {"steps", fmt::format("{}", steps)},
                {"every", fmt::format("{}", steps)},
                {"dump", name(stiffness, segment) + ".dump"},
                {"contacts_every", fmt::format("{}", look)},
                {"contacts", name(stiffness, segment) + ".contacts"}};
    }

    /// Runs all jobs; their files are left in the folder.
    void run(reference::LammpsFolder const& folder, std::string const& deck,
             std::vector<Segment> const& segments) const {
        std::vector<reference::LammpsJob> jobs;
        for (std::size_t s = 0; s < segments.size(); ++s)
            reference::write_lammps_data(folder / data(s), system, segments[s].start);
        for (std::size_t k = 0; k < stiffnesses.size(); ++k)
            for (std::size_t s = 0; s < segments.size(); ++s)
                jobs.push_back(job(k, s, segments[s].time));
        reference::run_lammps(folder, deck, jobs);
    }

    /// Where the soft balls of a job ended. Throws InputError unless they set out from where the
    /// segment starts, to the last bit.
    Eigen::Matrix3Xd end(reference::LammpsFolder const& folder, std::size_t stiffness,
                         std::size_t segment, Start const& start) const {
        auto const path = folder / (name(stiffness, segment) + ".dump");
        auto const frames = reference::read_lammps_dump(path);
        if (frames.size() != 2 || reference::balls_of(frames.front()).positions != start.positions)
            throw InputError(path.string() + ": does not begin where the segment begins");
        return reference::balls_of(frames.back()).positions;
    }
};

} // namespace clack::validation
