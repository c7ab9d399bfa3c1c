#pragma once
// A place in memory to draw on, and what is read back from it.

#include "view/camera.hpp"
#include "view/graphics.hpp"

#include <cstdint>
#include <vector>

namespace clack::view {

/// A framebuffer of so many samples.
struct Canvas {
    /// Throws InputError when OpenGL has no such size.
    explicit Canvas(PixelSize in_samples);

    PixelSize size; // in samples
    gl::Renderbuffer colour, depth;
    gl::Framebuffer frame;
};

/// Rows from the top, three bytes a pixel.
struct Pixels {
    PixelSize size;
    std::vector<std::uint8_t> rgb;
};

/// Reads from the framebuffer that is bound: each pixel is the mean light of its samples.
Pixels read_pixels(PixelSize size, int samples);

} // namespace clack::view
