#pragma once
// The program's commands. Each returns the exit code, prints its result on standard output, and
// throws InputError, LawBroken or WriteError for `main` to put into one line.

#include "cli/progress.hpp"
#include "cli/summary.hpp"
#include "view/view.hpp"

#include <string>
#include <vector>

namespace clack {

enum class Form { text, json };

/// Exit codes.
constexpr int exit_done = 0, exit_law_broken = 1, exit_mistake = 2;

/// How something is run, from its start or from where it stopped.
struct RunSettings {
    std::vector<std::string> overrides;
    Progress progress = Progress::shown;
    ShowHash hash = ShowHash::no;
    Form form = Form::text;
};

struct RunOptions : RunSettings {
    std::string scene;
    std::string output; // empty: the scene's stem in the current folder
};

/// From a scene to a trajectory.
int run_command(RunOptions const& options);

struct ResumeOptions : RunSettings {
    std::string trajectory;
};

/// Goes on where a file stops, to the same bits.
int resume_command(ResumeOptions const& options);

/// What a scene will be run with and cost, or what a trajectory holds.
int info_command(std::string const& path, std::vector<std::string> const& overrides);

/// Recomputes the laws from a trajectory; the exit code says whether they hold.
int check_command(std::string const& path);

struct ExportOptions {
    std::string trajectory;
    std::string output; // empty: the trajectory's stem in the current folder
};

/// Writes a trajectory's frames as extended XYZ.
int export_command(ExportOptions const& options);

/// Shows a scene or a trajectory, as pictures or in a window.
int view_command(view::Options options);

} // namespace clack
