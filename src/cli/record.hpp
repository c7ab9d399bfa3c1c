#pragma once
// What `run` and `resume` have in common: from a run that is ready to its file closed.

#include "cli/commands.hpp"
#include "cli/recorded_run.hpp"
#include "cli/summary.hpp"
#include "io/trajectory_header.hpp"
#include "io/trajectory_writer.hpp"

#include <string>

namespace clack {

TrajectoryHeader header_of(Scene const& scene, Engine const& engine);

void print_summary(Summary const& summary, Form form, ShowHash hash);

/// Runs to the goal, or until a signal, and closes the file. Says how to go on after a signal.
/// Returns the exit code. A broken law is told with the seed and the file that replay it.
int record(Scene const& scene, RecordedRun& run, TrajectoryWriter& writer, ProgressLine& line,
           std::string const& output);

} // namespace clack
