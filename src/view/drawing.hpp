#pragma once
// Draws a picture with OpenGL 3.3 into whatever framebuffer is bound, as a whole or bit by bit.

#include "view/ball_order.hpp"
#include "view/camera.hpp"
#include "view/graphics.hpp"
#include "view/picture.hpp"

#include <chrono>

namespace clack::view {

class Drawing {
public:
    Drawing();

    /// Begins a picture in the framebuffer that is bound now; pixels_per_pixel widens the lines of
    /// a picture that will be scaled down.
    void begin(Prepared prepared, PixelSize size, float pixels_per_pixel);
    /// Goes on drawing into the same framebuffer for about so long; true when all is drawn.
    bool go_on(std::chrono::duration<double> budget);
    /// Draws all that is left.
    void finish();

    std::size_t drawn_ball_count() const { return visible_.near.size() + visible_.dots.size(); }

private:
    struct Strip { // a line as the graphics card takes it
        Eigen::Vector3f from, to;
        Colour colour;
        std::uint8_t fades; // 255: with the distance
        float width;
    };

    void set_uniforms(gl::Program const& program);
    void draw_some_balls();
    void draw_balls(gl::Program const& program, std::vector<DrawnBall> const& balls,
                    std::size_t first, std::size_t count, GLenum form);
    void draw_lines(DrawnLine::Hiding hiding);
    void add_line(std::vector<Strip>& strips, DrawnLine const& line) const;
    void draw_strips(std::vector<Strip> const& strips);
    void draw_rings();

    gl::Program ball_, dot_, line_;
    gl::Vertices corner_vertices_, dot_vertices_, line_vertices_;
    gl::Buffer ball_buffer_, line_buffer_;

    Picture picture_;
    Camera camera_;
    PixelSize size_;
    float pixels_per_pixel_ = 1, nearest_ = 0, farthest_ = 1;
    VisibleBalls visible_;
    std::size_t drawn_ = 0, at_a_time_ = 256; // balls
    bool done_ = true;
};

/// The colour behind everything.
Eigen::Vector3f background_colour(Background background);

} // namespace clack::view
