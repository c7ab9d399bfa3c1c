#pragma once
// How far a ball may stray from where its list was made.

#include "state/system.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace clack {

/// The sphere that a ball stays in as long as its list holds  [length].
struct Shell {
    double radius;
    double reach; // between the centres of two shells whose balls might touch
    /// From a ball that gets a new list to the centre of its shell, along its flight: it goes on
    /// for a while before collisions turn it. In a dense fluid they throw it back. Counted at
    /// packing fractions 0.35, 0.40 and 0.49: least renewals at 0.18, 0.13 and 0 diameters, 0.87,
    /// 0.91 and 1 of those of a centre where the ball is; lists are 1.02, 1.01 and 1 times as fast.
    double ahead;

    /// Thick shells make long lists, thin ones many rebuilds. Measured at packing fractions 0.35 to
    /// 0.54 with 7 to 21 balls: best where a list just about fills a cache line.
    explicit Shell(System const& system) {
        constexpr double listed = 15; // balls, on average
        double const per_cubic_diameter = system.packing_fraction() * 6 / std::numbers::pi;
        double const wanted = std::cbrt(listed * 3 / (4 * std::numbers::pi * per_cubic_diameter));
        radius = system.diameter * std::clamp((wanted - 1) / 2, 0.15, 0.6);
        ahead = system.diameter * std::clamp(1.3 * (0.49 - system.packing_fraction()), 0.0, 0.25);
        // Of the float that the centres are compared in.
        double const rounding = 64 * 0x1p-24 * (system.diameter + system.side);
        reach = system.diameter + 2 * radius + rounding;
    }
};

} // namespace clack
