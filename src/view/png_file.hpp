#pragma once
// A picture in a file.

#include "view/canvas.hpp"

#include <string>

namespace clack::view {

/// Writes a PNG; the file appears when it is whole. Throws InputError when no such file can be made
/// and WriteError when writing fails.
void write_png(std::string const& path, Pixels const& pixels);

/// One below the other, all equally wide.
Pixels stacked(std::vector<Pixels> const& pictures);

} // namespace clack::view
