#pragma once
// The panel beside the picture.

#include "view/session.hpp"

namespace clack::view {

constexpr float panel_width = 330; // [pixels]

/// Figures of the drawing itself.
struct DrawingReport {
    double seconds = 0; // of the last picture
    std::size_t balls_drawn = 0;
};

/// Draws the panel, and the list of keys when it is asked for, with Dear ImGui.
void draw_panel(Session& session, DrawingReport const& report);

/// Below a scale: 0 at its left end, its name and what its right end stands for.
void scale_ends(std::string const& name, std::string const& top);
void scale_ends(std::string const& name, double top);

/// Z over time and now, with theory.
///   chart_height  [pixels]
void draw_pressure(Physics const& physics, Boundary boundary, float chart_height);

/// Measured speeds, with the laws that they follow; Z; what the engine keeps.
void draw_physics(Shown const& shown, float chart_height);

} // namespace clack::view
