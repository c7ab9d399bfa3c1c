#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/memory.hpp"
#include "cli/record.hpp"
#include "io/output_file.hpp"
#include "io/trajectory_reader.hpp"
#include "io/trajectory_writer.hpp"
#include "state/errors.hpp"

#include <filesystem>
#include <memory>

namespace clack {

namespace {

std::unique_ptr<Engine> start_engine(Scene const& scene) {
    auto const start = make_start(scene, last_frame);
    return make_engine(scene.system, scene.method, scene.precision, start);
}

} // namespace

int run_command(RunOptions const& options) {
    catch_interrupts();
    auto const scene = read_scene(options.scene, options.overrides);
    auto const output = real_path(options.output.empty()
                                      ? std::filesystem::path(options.scene).stem().string() + ".h5"
                                      : options.output);
    require_memory(scene);
    require_writable(output);
    auto const engine = start_engine(scene);

    auto const header = header_of(scene, *engine);
    defer_interrupts();
    TrajectoryWriter writer(output, header);
    ProgressLine line(options.progress);
    RecordedRun run(scene, *engine, writer, line);
    int const code = [&] {
        try {
            return record(scene, run, writer, line, output);
        } catch (InputError const&) { // the goal is never reached; is there anything to keep?
            if (engine->tallies().ball_collisions == 0) writer.discard();
            throw;
        }
    }();
    if (code == exit_done) {
        print_summary(summarize(scene, *engine, run.samples(), run.cpu_seconds()), options.form,
                      options.hash);
    }
    return code;
}

} // namespace clack
