#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/memory.hpp"
#include "cli/record.hpp"
#include "cli/schedule.hpp"
#include "io/file_errors.hpp"
#include "io/output_file.hpp"
#include "io/trajectory_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>

namespace clack {

namespace {

/// What may change without changing the motion: how far, and by which method.
constexpr std::array<std::string_view, 4> free_keys{"run.time", "run.collisions",
                                                    "run.collisions_per_ball", "run.method"};

Scene resumed_scene(TrajectoryHeader const& header, std::vector<std::string> const& overrides) {
    for (auto const& text : overrides) {
        auto const key = text.substr(0, text.find('='));
        if (std::find(free_keys.begin(), free_keys.end(), key) == free_keys.end()) {
            throw InputError("--set " + text +
                             ": would change the run that is resumed; only its goal (run.time, "
                             "run.collisions, run.collisions_per_ball) and run.method can be set");
        }
    }
    auto scene = parse_scene(header.scene_text, header.scene_source, overrides);
    scene.system = header.system; // to the last bit
    return scene;
}

/// The provenance of a file that several programs wrote: all of them, in order.
std::string joined(std::string const& earlier, std::string const& now) {
    return earlier.ends_with(now) ? earlier : earlier + "; then " + now;
}

TrajectoryHeader resumed_header(TrajectoryHeader const& old, Scene const& scene,
                                Engine const& engine) {
    auto header = header_of(scene, engine);
    header.horizon = old.horizon;
    auto const join = [&](std::string Provenance::*text) {
        header.provenance.*text = joined(old.provenance.*text, header.provenance.*text);
    };
    join(&Provenance::version);
    join(&Provenance::commit);
    join(&Provenance::compiler);
    join(&Provenance::flags);
    join(&Provenance::machine);
    return header;
}

/// Whether there is nothing left to do, which it says. Throws InputError when a new goal of an
/// unfinished run is behind it.
bool is_over(Schedule const& schedule, Phase phase, Engine const& engine, Scene const& scene,
             std::string const& path) {
    if (phase == Phase::equilibrating) return false;
    if (!schedule.is_reached(engine.time(), engine.tallies().ball_collisions)) return false;
    if (phase == Phase::finished) {
        fmt::print(stderr,
                   "clack: {} is finished; to go on, set a larger goal, as in --set "
                   "run.time={:.6g}\n",
                   path, 2 * engine.time());
        return true;
    }
    throw InputError(fmt::format("{}: the run is at t = {:.10g} with {} collisions, at or beyond "
                                 "the goal that was set; set a larger one ({})",
                                 path, engine.time(), engine.tallies().ball_collisions,
                                 scene.source));
}

} // namespace

int resume_command(ResumeOptions const& options) {
    catch_interrupts();
    auto const path = real_path(options.trajectory);
    std::optional<TrajectoryReader> file(std::in_place, path);
    require_writable(path);
    WriterLock const nobody_else(path);
    auto const scene = resumed_scene(file->header(), options.overrides);
    auto const before = resumed_scene(file->header(), {});
    require_memory(scene);
    auto point = file->resume_point();
    auto samples = file->samples(point.samples);
    auto const engine = make_engine(scene.system, scene.method, scene.precision, point.engine);

    Schedule const schedule(scene);
    bool const over = is_over(schedule, point.phase, *engine, scene, path);
    if (over && !file->left_open()) {
        print_summary(summarize(scene, *engine, samples, point.cpu_seconds), options.form,
                      options.hash);
        return exit_done;
    }
    // A finished file whose writer was killed before closing it is only written anew.
    if (!over && point.phase != Phase::equilibrating) {
        schedule.extend(Schedule(before), point, samples);
    }
    auto const header = resumed_header(file->header(), scene, *engine);
    defer_interrupts();
    TrajectoryWriter writer(path, header);
    writer.copy_from(*file, point, samples);
    file.reset();

    ProgressLine line(options.progress);
    RecordedRun run(scene, *engine, writer, line, std::move(point), std::move(samples));
    int const code = record(scene, run, writer, line, path);
    if (code == exit_done) {
        print_summary(summarize(scene, *engine, run.samples(), run.cpu_seconds()), options.form,
                      options.hash);
    }
    return code;
}

} // namespace clack
