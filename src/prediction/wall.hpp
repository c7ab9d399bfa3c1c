#pragma once
// When a ball and a wall will touch.

#include "state/container.hpp"

#include <cstdint>

namespace clack {

/// The wall that a ball will reach first: 0..5 = x-, x+, y-, y+, z-, z+.
template <class Real> struct WallContact {
    Real time = infinity<Real>;
    std::int32_t wall = 0;
};

/// The linear equation for each direction of flight; never before the record's own time, so a ball
/// that rounding left beyond a plane it flies towards reaches it at once. Equal times (an edge, a
/// corner) go to the lower wall.
template <class Real>
WallContact<Real> earliest_wall(Ball<Real> const& ball, WalledCube<Real> const& cube) {
    WallContact<Real> best;
    for (std::int32_t d = 0; d < 3; ++d) {
        Real const v = ball.velocity[d];
        if (v == 0) continue;
        Real const plane = v > 0 ? cube.high : cube.low;
        Real const wait = (plane - ball.point[d]) / v;
        Real const time = wait > 0 ? ball.time + wait : ball.time;
        if (time < best.time) best = {time, 2 * d + (v > 0 ? 1 : 0)};
    }
    return best;
}

/// A periodic cube has no walls.
template <class Real>
WallContact<Real> earliest_wall(Ball<Real> const&, PeriodicCube<Real> const&) {
    return {};
}

} // namespace clack
