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
};

struct Picture {
    Background background = Background::light;
    float radius = 0.1f; // of all balls [sides of the cube]
    float clip = 1;      // balls whose centres are nearer than this along -y are left out
    std::vector<DrawnBall> balls;
    std::vector<DrawnLine> lines;
    std::vector<DrawnRing> rings;
};

} // namespace clack::view
