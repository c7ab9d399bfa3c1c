#pragma once
// The largest and smallest numbers that a scene can hold, each with its reason.

#include "simulation/engine.hpp"

#include <cstdint>

namespace clack {

/// Balls are numbered in 27 bits.
constexpr std::int64_t largest_count_of_balls = (std::int64_t{1} << 27) - 1;

/// Collisions in a run: counters of 64 bits keep far from their end.
constexpr double most_collisions = 1e18;

/// Crossings of the cube in a run: whole epochs of the clock are counted in 64 bits.
constexpr double most_crossings = 1e15;

/// Longest run in which nothing moves: what a clock in float still holds in one epoch.
constexpr double longest_rest = 1e37;

/// Frames in a file.
constexpr double most_frames = 1e9;

/// Shortest time between frames, in times in which a ball moves its own diameter: shorter ones
/// would be lost in the rounding of the time.
constexpr double shortest_frame_interval = 1e-9;

/// What lengths, masses, energies and speeds may be, so that the engine's products of up to four of
/// them neither overflow nor vanish.
struct Magnitudes {
    double smallest, largest;
};
constexpr Magnitudes magnitudes(Precision precision) {
    return precision == Precision::single_ ? Magnitudes{1e-6, 1e6} : Magnitudes{1e-50, 1e50};
}

/// Largest side in diameters. Places are rounded to side / 2^24 in float: at 1e3 diameters to less
/// than 1e-4 diameters. Double keeps 1e-7 diameters at 1e9.
constexpr double largest_side_in_diameters(Precision precision) {
    return precision == Precision::single_ ? 1.5e3 : 1e9;
}

/// Explicit places with periodic boundaries, in sides from the origin: further out wrapping them
/// would lose their digits.
constexpr double furthest_image = 1e6;

} // namespace clack
