#pragma once
// The scenes of work_precision by methods that step through time: frames as games do it, and the
// soft balls of LAMMPS.

#include "reference/frame_stepping.hpp"
#include "validation/work_precision.hpp"

#include <fstream>

namespace clack::validation::work_precision {

constexpr int spans = 3; // final times that stepped runs are followed for

/// Frames with a step of so many mean free times.
inline Point frames_point(Scenery const& scenery, double const step, Run const& oracle) {
    auto const steps = static_cast<std::int64_t>(std::ceil(final_time / step));
    double const time = final_time * scenery.mean_free_time;
    reference::FrameStepping frames(scenery.system, scenery.start,
                                    time / static_cast<double>(steps));
    double const begin = processor_seconds();
    double const energy = scenery.start.velocities.squaredNorm();
    frames.advance(steps);
    Run run;
    run.places = frames.balls().positions.cast<quad>();
    frames.advance((spans - 1) * steps);
    double const seconds = processor_seconds() - begin;
    Segment segment;
    segment.start = scenery.start;
    for (auto const& [i, j] : frames.pairs())
        segment.meetings.push_back({CollisionKind::ball, 0, i, j});
    run.partners = collision_prefix::partners_of(segment);
    run.deepest_overlap = frames.tallies().deepest_overlap;
    run.energy_drift = std::abs(frames.balls().velocities.squaredNorm() / energy - 1);
    Point made = compare(run, oracle);
    made.cost = seconds / (spans * final_time * static_cast<double>(scenery.system.count));
    return made;
}

/// The knobs of LAMMPS.
struct Softness {
    double stiffness, steps_per_contact;
};

/// What the log says that the time loops took, job after job.  [s]
inline std::vector<double> loop_seconds(reference::LammpsFolder const& folder) {
    constexpr std::string_view head = "Loop time of ";
    std::vector<double> all;
    std::ifstream log(folder / "lammps.log");
    for (std::string line; std::getline(log, line);)
        if (line.starts_with(head)) all.push_back(std::stod(line.substr(head.size())));
    return all;
}

/// A job that dumps the balls at each final time, and the pairs that touch often.
inline reference::LammpsJob job(Scenery const& scenery, Softness const& soft,
                                std::string const& name) {
    constexpr double looks_per_contact = 5;
    double const time = final_time * scenery.mean_free_time;
    double const contacts = time / reference::contact_duration(soft.stiffness);
    auto const steps = static_cast<std::int64_t>(std::ceil(contacts * soft.steps_per_contact));
    auto const look = static_cast<std::int64_t>(soft.steps_per_contact / looks_per_contact);
    auto const number = [](auto const x) { return fmt::format("{:.17g}", static_cast<double>(x)); };
    return {{"data", "start.data"},
            {"side", number(scenery.system.side)},
            {"k", number(soft.stiffness)},
            {"kw", number(2 * soft.stiffness)},
            {"dt", number(time / static_cast<double>(steps))},
            {"steps", fmt::format("{}", spans * steps)},
            {"every", fmt::format("{}", steps)},
            {"dump", name + ".dump"},
            {"contacts_every", fmt::format("{}", look)},
            {"contacts", name + ".contacts"}};
}

/// Soft balls with several knobs. Their overlap is v t_c / pi of the fastest pair, by design, and
/// is not dumped: the depth of a pair at the mean normal speed stands for it.
inline std::vector<Point> lammps_points(Scenery const& scenery, std::vector<Softness> const& knobs,
                                        std::string const& deck, Run const& oracle) {
    reference::LammpsFolder const folder;
    reference::write_lammps_data(folder / "start.data", scenery.system, scenery.start);
    std::vector<reference::LammpsJob> jobs;
    for (std::size_t k = 0; k < knobs.size(); ++k)
        jobs.push_back(job(scenery, knobs[k], fmt::format("{}", k)));
    reference::run_lammps(folder, deck, jobs);
    auto const seconds = loop_seconds(folder);
    double const energy = scenery.start.velocities.squaredNorm();
    std::vector<Point> points;
    for (std::size_t k = 0; k < knobs.size(); ++k) {
        auto const frames = reference::read_lammps_dump(folder / fmt::format("{}.dump", k));
        auto const touching = reference::read_lammps_dump(folder / fmt::format("{}.contacts", k));
        Run run;
        run.places = reference::balls_of(frames.at(1)).positions.cast<quad>();
        run.partners = collision_prefix::partners_of(reference::collisions_seen(touching),
                                                     scenery.system.count);
        double const normal_speed = std::sqrt(std::numbers::pi); // mean, at kT = m = 1
        run.deepest_overlap =
            normal_speed * reference::contact_duration(knobs[k].stiffness) / std::numbers::pi;
        run.energy_drift =
            std::abs(reference::balls_of(frames.back()).velocities.squaredNorm() / energy - 1);
        points.push_back(compare(run, oracle));
        points.back().cost =
            seconds.at(k) / (spans * final_time * static_cast<double>(scenery.system.count));
    }
    return points;
}

} // namespace clack::validation::work_precision
