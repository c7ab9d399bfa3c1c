#pragma once
// Which balls are seen at all, and in which order they are drawn.
//
// Of two equal balls that do not overlap the one whose centre is nearer to the eye is in front
// wherever both are seen: the plane half way between the centres parts them, and the eye is on its
// side. So balls need no depth of their own in every pixel, can be drawn front to back, and one
// that is behind others already drawn can be left out.

#include "view/camera.hpp"
#include "view/picture.hpp"

#include <stop_token>
#include <vector>

namespace clack::view {

/// The balls to draw, nearest first. Those so small in the picture that a dot will do come last.
struct VisibleBalls {
    std::vector<DrawnBall> near, dots;
};

/// A picture on its way to the graphics card.
struct Prepared {
    Picture picture; // its balls are in `visible`
    Camera camera;
    VisibleBalls visible;
};

/// Leaves out what is outside the picture, cut away, or hidden behind nearer balls.
class BallOrder {
public:
    VisibleBalls visible(Picture const& picture, Camera const& camera, PixelSize size,
                         std::stop_token const& stop = {});
    /// Of a picture that nobody waits for any more, no more balls than there are by then.
    Prepared prepare(Picture picture, Camera const& camera, PixelSize size,
                     std::stop_token const& stop = {});

    /// Radius below which a ball is a dot  [pixels]
    static constexpr float dot_radius = 3;

private:
    struct Disc {
        float x, y, radius; // [pixels]
    };

    void sort_by_distance(Picture const& picture, Eigen::Vector3f const& eye);
    void clear_screen(float radius_in_pixels, PixelSize size);
    bool is_hidden(Disc const& disc) const;
    void cover(Disc const& disc);
    template <class Visit> bool each_cell_row(Disc const& disc, Visit const& visit) const;

    std::vector<std::uint32_t> order_, starts_;
    std::vector<std::uint16_t> keys_;
    std::vector<std::uint8_t> covered_; // cells of the picture behind which nothing is seen
    float cell_ = 4;                    // [pixels]
    int columns_ = 0, rows_ = 0;
};

} // namespace clack::view
