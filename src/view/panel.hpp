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

/// The ends of a scale, 0 at the left.
void scale_ends(std::string const& top);

/// Z over time and now, with theory.
void draw_pressure(Physics const& physics, Boundary boundary);

/// Measured speeds, with the laws that they follow.
void draw_physics(Shown const& shown);

} // namespace clack::view
