#pragma once
// The engine's own answer to soft balls: hard ones whose diameter depends on how fast they meet.

#include "resolution/elastic_balls.hpp"

namespace clack::validation {

/// Balls that overlap for a time t_c before a linear spring has turned them round leave one another
/// as hard balls do that meet a little deeper, at
///   d - v_n t_c / 2,
/// v_n being the normal relative speed as it is there: exactly in head-on collisions, and but for
/// O(t_c^2) in all others. A wall turns a ball round v_n t_c / 2 beyond its plane.
/// Collisions that follow one another within t_c have no such counterpart; where one finds the pair
/// nearer than its diameter, it collides where it is.
template <class Real> struct SoftenedBalls : ElasticBalls<Real> {
    Real diameter, lag; // t_c / 2

    SoftenedBalls(System const& system, double contact_duration)
        : ElasticBalls<Real>(system), diameter(static_cast<Real>(system.diameter)),
          lag(static_cast<Real>(contact_duration / 2)) {}

    /// At contact the speed v and h = |r x v|, which do not change on the way, give the normal
    /// speed u as the root of (d - u lag)^2 (v^2 - u^2) = h^2. The left side falls from (d v)^2 at
    /// 0 to 0 at v, and bends down; so Newton's steps from beyond the root, where u is for a ball
    /// that does not yield, come down to it, and each squares the distance.
    template <class Number>
    [[gnu::always_inline]] Number contact_time(Pair<Number> const& p) const {
        Number const zero{};
        Number never = zero + std::numeric_limits<Real>::quiet_NaN();
        Number const b = p.x * p.vx + p.y * p.vy + p.z * p.vz;
        Number const distance2 = p.x * p.x + p.y * p.y + p.z * p.z;
        Number const speed2 = p.vx * p.vx + p.vy * p.vy + p.vz * p.vz;
        Number const cross_x = p.y * p.vz - p.z * p.vy;
        Number const cross_y = p.z * p.vx - p.x * p.vz;
        Number const cross_z = p.x * p.vy - p.y * p.vx;
        Number const cross2 = cross_x * cross_x + cross_y * cross_y + cross_z * cross_z;
        // Not a number where they pass each other by, and so through to the end.
        Number normal_speed = square_root(speed2 - cross2 / this->squared);
        constexpr int steps = 6; // from 1e-2 to far below the rounding
        for (int step = 0; step < steps; ++step) {
            Number const reach = diameter - normal_speed * lag;
            Number const rest = speed2 - normal_speed * normal_speed;
            Number const excess = reach * reach * rest - cross2;
            normal_speed =
                normal_speed + excess / (2 * reach * (lag * rest + reach * normal_speed));
        }
        Number const reach = diameter - normal_speed * lag;
        Number const gap2 = distance2 - reach * reach;
        Number const when = p.time + select(gap2 > zero, gap2, zero) / (normal_speed * reach - b);
        return select(b < zero, when, never);
    }

    Real diameter_squared(Pair<Real> const& p, Real /*time*/) const {
        using std::sqrt;
        Real const distance2 = p.x * p.x + p.y * p.y + p.z * p.z;
        Real const normal_speed = -(p.x * p.vx + p.y * p.vy + p.z * p.vz) / sqrt(distance2);
        Real const reach = diameter - normal_speed * lag;
        return select(distance2 < reach * reach, distance2, reach * reach);
    }

    /// A plane that is reached later by half a contact.
    WallContact<Real> wall_contact(Ball<Real> const& ball, WalledCube<Real> const& cube) const {
        WallContact<Real> contact = earliest_wall(ball, cube);
        contact.time += lag;
        return contact;
    }

    Real plane(WalledCube<Real> const& cube, int towards, Real /*time*/, Real component) const {
        return (towards < 0 ? cube.low : cube.high) + component * lag;
    }
};

} // namespace clack::validation
