#pragma once
// The scenes of work_precision by methods that step through time: frames as games do it, and the
// soft balls of LAMMPS.

#include "reference/frame_stepping.hpp"
#include "validation/work_precision.hpp"

#include <fmt/ranges.h>

#include <fstream>

namespace clack::validation::work_precision {

constexpr int spans = 3; // final times that stepped runs are followed for

/// What they are held against.
inline Run oracle_of_steps(Scenery const& place) {
    return run(place, Method::fast, Precision::quadruple, place.start, spans * final_time);
}

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
    std::vector<Meeting> meetings;
    for (auto const& [i, j] : frames.pairs()) meetings.push_back({CollisionKind::ball, 0, i, j});
    run.partners = partners_of(meetings, scenery.system.count);
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
        run.partners = partners_of(reference::collisions_seen(touching), scenery.system.count);
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

/// The lines of a chart that are measured together.
struct Group {
    std::string what; // with the knobs, by which a campaign tells one profile from another
    std::vector<Line> lines;
    int replicates;
    Measure measure;
};

inline Group frames_group(StatePoint const& point, Profile const profile) {
    std::vector<double> steps{0.3, 0.1, 0.03, 0.01};
    if (point.count < 1000 || profile == Profile::full) steps.insert(steps.end(), {3e-3, 1e-3});
    Group group{fmt::format("frames {}", fmt::join(steps, ",")), {}, 1, {}};
    for (double const step : steps) group.lines.push_back({"frames", fmt::format("{:g}", step)});
    group.measure = [=](std::uint64_t const seed) {
        Scenery const place = scenery(point, seed);
        Run const oracle = oracle_of_steps(place);
        Measurement values;
        for (double const step : steps) append(values, frames_point(place, step, oracle));
        return values;
    };
    return group;
}

inline Group lammps_group(StatePoint const& point, Profile const profile) {
    std::vector<Softness> all{{1e4, 10}, {1e4, 50}, {1e5, 20}, {1e6, 20}};
    if (point.count < 1000 && point.packing_fraction > 0.1) all.push_back({1e7, 20});
    if (point.count == 1000 && profile == Profile::quick) all = {{1e4, 20}};
    std::string const deck = reference::lammps_deck("lammps_cube.in");
    Group group{"lammps ", {}, 1, {}};
    for (Softness const& soft : all) {
        std::string const knob =
            fmt::format("k={:g};n={:g}", soft.stiffness, soft.steps_per_contact);
        group.what += (group.lines.empty() ? "" : ",") + knob;
        group.lines.push_back({"lammps", knob});
    }
    group.what += fmt::format(" deck={:016x}", hash_of(deck));
    group.measure = [=](std::uint64_t const seed) {
        Scenery const place = scenery(point, seed);
        Measurement values;
        for (Point const& made : lammps_points(place, all, deck, oracle_of_steps(place)))
            append(values, made);
        return values;
    };
    return group;
}

/// All that is measured at a state point.
inline std::vector<Group> groups(StatePoint const& point, Profile const profile) {
    Group engine{"engine", {}, point.replicates, [=](std::uint64_t const seed) {
                     return measure_engine(point, seed);
                 }};
    for (auto const& [precision, method] : engine_lines(point))
        engine.lines.push_back({name_of(method), name_of(precision)});
    return {engine, frames_group(point, profile), lammps_group(point, profile)};
}

} // namespace clack::validation::work_precision
