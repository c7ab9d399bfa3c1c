#pragma once
// Pictures without a window, a display or a graphics card.

#include "view/canvas.hpp"
#include "view/drawing.hpp"

#include <memory>

namespace clack::view {

/// A context of OpenGL that draws into memory (EGL without a surface). Throws InputError where
/// there is none.
class Offscreen {
public:
    /// Each pixel is the mean of samples x samples.
    Offscreen(PixelSize size, int samples);
    Offscreen(Offscreen const&) = delete;
    Offscreen& operator=(Offscreen const&) = delete;
    ~Offscreen();

    /// The same picture gives the same pixels on the same machine.
    Pixels draw(Picture const& picture, Camera const& camera);

private:
    struct Context;
    struct Target;

    PixelSize size_;
    int samples_;
    std::unique_ptr<Context> context_; // outlives what was made in it
    std::unique_ptr<Target> target_;
};

} // namespace clack::view
