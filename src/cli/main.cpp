#include "cli/commands.hpp"
#include "cli/memory.hpp"
#include "cli/view_options.hpp"
#include "io/file_errors.hpp"
#include "io/provenance.hpp"
#include "simulation/engine.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <functional>
#include <new>
#include <string>

namespace {

using namespace clack;

char const* const description =
    "Exact event-driven motion of many equal hard balls in a cube.\n"
    "A scene file goes in, an H5MD file comes out; see validation/scenes for scenes to start from.";

char const* const footer =
    "Exit codes: 0 done; 1 a law of nature is broken, a check has failed, or the file cannot be\n"
    "written; 2 the command, the scene or a file is at fault; 130 interrupted, the file closed "
    "and\n"
    "resumable.";

/// Options that `run` and `resume` share.
void add_run_options(CLI::App& command, RunSettings& options) {
    command
        .add_option(
            "--set", options.overrides,
            "SECTION.KEY=VALUE in place of what the scene says, as in run.seed=7; repeatable")
        ->type_name("")
        ->allow_extra_args(false);
    command.add_flag_callback(
        "--quiet", [&] { options.progress = Progress::hidden; }, "no progress on standard error");
    command.add_flag_callback(
        "--hash", [&] { options.hash = ShowHash::yes; },
        "the hash of the collision sequence in the summary");
    command.add_flag_callback(
        "--json", [&] { options.form = Form::json; }, "the summary as one JSON object");
}

void add_run(CLI::App& app, std::function<int()>& chosen, RunOptions& options) {
    auto& command = *app.add_subcommand("run", "run a scene");
    command.add_option("SCENE", options.scene, "scene file (.toml)")->required()->type_name("");
    command
        .add_option("-o,--output", options.output,
                    "trajectory to write; a trajectory of that name is replaced [SCENE's stem .h5]")
        ->type_name("FILE");
    add_run_options(command, options);
    command.footer("SIGINT and SIGTERM close the file so that `clack resume` goes on to the same "
                   "bits,\nalso while the run still equilibrates.");
    command.callback([&] { chosen = [&] { return run_command(options); }; });
}

void add_resume(CLI::App& app, std::function<int()>& chosen, ResumeOptions& options) {
    auto& command = *app.add_subcommand("resume", "go on where a file stops, to the same bits");
    command.add_option("FILE", options.trajectory, "trajectory of clack (.h5)")
        ->required()
        ->type_name("");
    add_run_options(command, options);
    command.footer("Only the goal (run.time, run.collisions, run.collisions_per_ball) and "
                   "run.method can be set.");
    command.callback([&] { chosen = [&] { return resume_command(options); }; });
}

void add_scene_or_trajectory(CLI::App& command, std::string& path,
                             std::vector<std::string>& overrides) {
    command.add_option("FILE", path, "scene (.toml) or trajectory (.h5)")
        ->required()
        ->type_name("");
    command.add_option("--set", overrides, "as for run; scenes only")
        ->type_name("SECTION.KEY=VALUE")
        ->allow_extra_args(false);
}

struct InfoOptions {
    std::string path;
    std::vector<std::string> overrides;
};

void add_info(CLI::App& app, std::function<int()>& chosen, InfoOptions& options) {
    auto& command = *app.add_subcommand(
        "info", "what a scene will be run with and cost; what a trajectory holds");
    add_scene_or_trajectory(command, options.path, options.overrides);
    command.callback(
        [&] { chosen = [&] { return info_command(options.path, options.overrides); }; });
}

void add_check(CLI::App& app, std::function<int()>& chosen, std::string& path) {
    auto& command = *app.add_subcommand("check", "recompute the laws from a trajectory: overlaps, "
                                                 "energy, momentum, order of events");
    command.add_option("FILE", path, "trajectory of clack (.h5)")->required()->type_name("");
    command.callback([&] { chosen = [&] { return check_command(path); }; });
}

void add_export(CLI::App& app, std::function<int()>& chosen, ExportOptions& options) {
    auto& command = *app.add_subcommand("export", "write the frames as extended XYZ");
    command.add_option("FILE", options.trajectory, "trajectory of clack (.h5)")
        ->required()
        ->type_name("");
    command
        .add_option("-o,--output", options.output,
                    "file to write, - for standard output [FILE's stem .xyz]")
        ->type_name("FILE");
    command.callback([&] { chosen = [&] { return export_command(options); }; });
}

void add_view(CLI::App& app, std::function<int()>& chosen, view::Options& options) {
    auto& command = *app.add_subcommand(
        "view", "see a scene run, or a trajectory replayed: in a window, as a picture or a movie");
    add_scene_or_trajectory(command, options.path, options.overrides);
    add_view_options(command, options);
    command.footer("In the window ? lists the keys.");
    command.callback([&] { chosen = [&] { return view_command(options); }; });
}

/// One line on standard error, whatever the message.
int fail(int code, std::string message) {
    for (auto& letter : message) {
        if (letter == '\n') letter = ' ';
    }
    fmt::print(stderr, "clack: {}\n", message);
    return code;
}

int run_chosen(std::function<int()> const& chosen) {
    try {
        return chosen();
    } catch (InputError const& error) {
        return fail(exit_mistake, error.what());
    } catch (std::bad_alloc const&) {
        return fail(exit_mistake, "out of memory; use fewer balls or a larger machine");
    } catch (std::exception const& error) { // a law broken, a disk full
        return fail(exit_law_broken, error.what());
    }
}

} // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN); // a file at its size limit is an error of writing, not a death
    std::signal(SIGPIPE, SIG_DFL);
    give_back_what_is_freed();

    CLI::App app(description, "clack");
    app.set_version_flag("--version", "clack " + own_provenance().version + " (" +
                                          own_provenance().commit + ")");
    app.require_subcommand(0, 1); // none is told below, so that a misspelt one is named
    app.footer(footer);
    std::function<int()> chosen;
    RunOptions run;
    ResumeOptions resume;
    InfoOptions info;
    std::string check;
    ExportOptions exported;
    view::Options viewed;
    add_run(app, chosen, run);
    add_resume(app, chosen, resume);
    add_info(app, chosen, info);
    add_check(app, chosen, check);
    add_export(app, chosen, exported);
    add_view(app, chosen, viewed);
    try {
        app.parse(argc, argv);
    } catch (CLI::Success const& asked) { // --help, --version
        return app.exit(asked);
    } catch (CLI::ParseError const& error) {
        return fail(exit_mistake, std::string(error.what()) + "; see clack --help");
    }
    if (!chosen) {
        return fail(exit_mistake,
                    "no command: give run, resume, info, check, export or view; see clack --help");
    }
    return run_chosen(chosen);
}
