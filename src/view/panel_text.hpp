#pragma once
// One line of the panel.

#include <imgui.h>

#include <string>

namespace clack::view {

inline void text(std::string const& line) { ImGui::TextUnformatted(line.c_str()); }

} // namespace clack::view
