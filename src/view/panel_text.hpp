#pragma once
// What the parts of the panel are written with.

#include "view/picture.hpp"

#include <imgui.h>

#include <string>

namespace clack::view {

constexpr ImU32 axis_colour = IM_COL32(150, 150, 150, 255); // of charts

inline void text(std::string const& line) { ImGui::TextUnformatted(line.c_str()); }

inline void text(std::string const& line, ImVec4 const& colour) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    text(line);
    ImGui::PopStyleColor();
}

inline ImVec4 on_screen(Colour const& colour) {
    return ImGui::ColorConvertU32ToFloat4(IM_COL32(colour[0], colour[1], colour[2], 255));
}

} // namespace clack::view
