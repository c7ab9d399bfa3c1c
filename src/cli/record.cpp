#include "cli/record.hpp"

#include "cli/interrupt.hpp"
#include "io/file_errors.hpp"
#include "reference/horizon.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace clack {

TrajectoryHeader header_of(Scene const& scene, Engine const& engine) {
    TrajectoryHeader header;
    header.scene_text = scene.text;
    header.scene_source = scene.source;
    header.system = engine.system();
    header.events = scene.events;
    auto const checkpoint = engine.checkpoint();
    header.limbs = checkpoint.limbs;
    header.epoch_length = checkpoint.epoch_length;
    header.seed = scene.seed;
    header.model = engine.model();
    double const kt = temperature(engine.system(), engine.kinetic_energy(), engine.momentum());
    header.horizon = reference::horizon(engine.system(), scene.precision,
                                        reference::rough_collision_rate(engine.system(), kt));
    return header;
}

void print_summary(Summary const& summary, Form form, ShowHash hash) {
    fmt::print("{}", form == Form::json ? as_json(summary) : as_text(summary, hash));
    if (std::fflush(stdout) != 0) throw WriteError("standard output: cannot be written");
}

int record(Scene const& scene, RecordedRun& run, TrajectoryWriter& writer, ProgressLine& line,
           std::string const& output) {
    auto const end = [&] {
        try {
            return run.run();
        } catch (LawBroken const& broken) { // enough to replay it
            throw LawBroken(fmt::format("{} (seed {}, {})", broken.what(), scene.seed, output));
        }
    }();
    writer.close();
    line.clear();
    if (end == RecordedRun::End::finished) return exit_done;
    fmt::print(stderr, "clack: interrupted; go on with: clack resume {}\n", output);
    return interrupted_exit_code;
}

} // namespace clack
