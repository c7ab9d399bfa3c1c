#pragma once
// The balls' part of the window: drawn bit by bit behind the scenes, shown when it is whole.

#include "view/canvas.hpp"
#include "view/drawing.hpp"

#include <chrono>
#include <initializer_list>
#include <memory>

namespace clack::view {

/// Two canvases: one is shown while the other is drawn. A large picture takes longer than the
/// window may be deaf, so it is drawn in pieces.
class Canvases {
public:
    /// Draws a little of everything once and forgets it: drivers translate a shader when it first
    /// draws, which takes as long as the window may be deaf.
    void warm_up(PixelSize window, std::initializer_list<int> samples);

    void begin(Prepared prepared, PixelSize size, int samples);
    bool is_drawing() const { return is_drawing_; }
    double seconds_so_far() const { return seconds_; } // spent on the picture that is being drawn
    /// Draws for about so long; true when the picture has become whole and is the one to show.
    bool go_on(std::chrono::duration<double> budget);

    /// Copies the last whole picture into the window, scaled to it.
    void show(PixelSize window) const;
    int shown_samples() const { return shown_ ? shown_->samples : 1; }

    double seconds_of_last() const { return seconds_of_last_; } // that drawing took
    std::size_t balls_drawn() const { return balls_drawn_; }

private:
    Drawing drawing_;
    std::unique_ptr<Canvas> shown_, next_;
    bool is_drawing_ = false;
    double seconds_ = 0, seconds_of_last_ = 0;
    std::size_t balls_drawn_ = 0;
};

} // namespace clack::view
