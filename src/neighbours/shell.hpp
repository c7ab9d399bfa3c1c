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

    /// Thick shells make long lists, thin ones many rebuilds. Measured at packing fractions 0.35 to
    /// 0.54 with 7 to 21 balls: best where a list just about fills a cache line.
    explicit Shell(System const& system) {
        constexpr double listed = 14; // balls, on average
        double const per_cubic_diameter = system.packing_fraction() * 6 / std::numbers::pi;
        double const wanted = std::cbrt(listed * 3 / (4 * std::numbers::pi * per_cubic_diameter));
        radius = system.diameter * std::clamp((wanted - 1) / 2, 0.15, 0.6);
        // Of the float that the centres are compared in.
        double const rounding = 64 * 0x1p-24 * (system.diameter + system.side);
        reach = system.diameter + 2 * radius + rounding;
    }
};

} // namespace clack
