#pragma once
// How a view is asked for on the command line.

#include "view/view.hpp"

#include <CLI/CLI.hpp>

namespace clack {

/// Adds the options of pictures and movies, of the camera and of what is cut away.
///   options   what they fill in; must live until the command line is parsed
void add_view_options(CLI::App& command, view::Options& options);

} // namespace clack
