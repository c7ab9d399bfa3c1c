#pragma once
// The balls' part of the window: drawn bit by bit behind the scenes, shown when it is whole.

#include "view/canvas.hpp"
#include "view/drawing.hpp"

#include <chrono>
#include <memory>
#include <vector>

namespace clack::view {

/// Samples along a pixel of the window.
constexpr float coarsest = 0.5f, finest = 2;

/// The samples of a picture that is so fine.
PixelSize finer(PixelSize window, float fineness);

/// Canvases of which one is shown while the other is drawn. A large picture takes longer than the
/// window may be deaf, so it is drawn in pieces.
class Canvases {
public:
    /// Draws a little of everything once and forgets it: drivers translate a shader when it first
    /// draws, which takes as long as the window may be deaf.
    void warm_up(PixelSize window);

    /// A picture of so many samples along each pixel of the window: coarse ones are drawn sooner.
    void begin(Prepared prepared, PixelSize window, float fineness);
    /// Gives up the picture that is being drawn.
    void leave() { is_drawing_ = false; }
    bool is_drawing() const { return is_drawing_; }
    double seconds_so_far() const { return seconds_; } // spent on the picture that is being drawn
    /// Draws for about so long; true when the picture has become whole and is the one to show.
    bool go_on(std::chrono::duration<double> budget);

    /// Copies the last whole picture into the window, scaled to it.
    void show(PixelSize window) const;
    float shown_fineness() const { return shown_fineness_; }

    double seconds_of_last() const { return seconds_of_last_; } // that drawing took
    std::size_t balls_drawn() const { return balls_drawn_; }

private:
    void take_canvas(PixelSize size);

    Drawing drawing_;
    std::unique_ptr<Canvas> shown_, next_;
    std::vector<std::unique_ptr<Canvas>> spare_; // of other finenesses: to make one takes long
    float shown_fineness_ = 0, next_fineness_ = 0;
    bool is_drawing_ = false;
    double seconds_ = 0, seconds_of_last_ = 0;
    std::size_t balls_drawn_ = 0;
};

} // namespace clack::view
