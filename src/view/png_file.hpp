#pragma once
// A picture in a file.

#include "view/canvas.hpp"

#include <string>

namespace clack::view {

/// Writes a PNG; the file appears when it is whole. Throws InputError when no such file can be made
/// and WriteError when writing fails.
void write_png(std::string const& path, Pixels const& pixels);

/// Equal pictures in one: one below the other if they are wide strips, else side by side.
Pixels joined(std::vector<Pixels> const& pictures);

} // namespace clack::view
