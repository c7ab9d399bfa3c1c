#pragma once
// The window.

#include "view/source.hpp"
#include "view/view.hpp"

#include <memory>

namespace clack::view {

/// Opens a window on a source and returns when it is closed. Throws InputError where there is no
/// window system or no OpenGL 3.3.
void show_window(Options const& options, std::unique_ptr<Source> source);

} // namespace clack::view
