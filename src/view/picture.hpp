#pragma once
// What is to be drawn at one instant, in colours and lines: no physics any more.

#include "view/view.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace clack::view {

/// Red, green and blue as a screen takes them.
using Colour = std::array<std::uint8_t, 3>;

/// One ball as the graphics card takes it. Lengths in sides of the cube.
struct DrawnBall {
    float x, y, z;
    Colour colour;
    std::uint8_t glow; // 255 at a collision
};

/// A straight line, and whether balls in front of it hide it.
struct DrawnLine {
    enum class Hiding { by_balls, never };
    Eigen::Vector3f from, to; // [sides of the cube]
    Colour colour;
    float width; // [pixels]
    Hiding hiding;
};

/// A circle around a ball that shows through all others.
struct DrawnRing {
    Eigen::Vector3f centre; // [sides of the cube]
    Colour colour;
    float width; // of the circle, in those that mark one ball
};

/// A plane that cuts the cube open: what lies between it and a face is not drawn.
struct Cut {
    Face from = Face::front;
    double share = 1; // of the cube's depth, seen from the face, that is drawn

    int axis() const { return static_cast<int>(from) / 2; }
    bool is_from_zero() const { return static_cast<int>(from) % 2 == 0; }
    bool is_whole() const { return share >= 1; }
    /// Where the plane crosses its axis  [sides of the cube]
    float plane() const { return static_cast<float>(is_from_zero() ? 1 - share : share); }
    /// Whether a ball with its centre there is cut away; whole balls are left standing.
    bool hides(Eigen::Vector3f const& place) const {
        constexpr float rounding = 1e-6f;
        if (is_whole()) return false;
        float const behind = place[axis()] - plane();
        return (is_from_zero() ? behind : -behind) < -rounding;
    }

    bool operator==(Cut const&) const = default;
};

struct Picture {
    Background background = Background::light;
    float radius = 0.1f; // of all balls [sides of the cube]
    Cut cut;
    std::vector<DrawnBall> balls;
    std::vector<DrawnLine> lines;
    std::vector<DrawnRing> rings;
};

} // namespace clack::view
