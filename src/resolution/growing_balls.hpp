#pragma once
// Balls whose diameter grows at a steady rate while they move (B. D. Lubachevsky, F. H. Stillinger,
// J. Stat. Phys. 60, 561 (1990)): how dense random starts are made.

#include "prediction/contact.hpp"
#include "prediction/wall.hpp"
#include "state/system.hpp"

#include <cstdint>
#include <limits>

namespace clack {

/// diameter(t) = the system's diameter + rate t, up to `widest`.
template <class Real> struct GrowingBalls {
    Real diameter, rate, widest;

    static constexpr bool grows = true;
    static constexpr bool keeps_energy = false; // the surfaces push

    Real diameter_at(Real time) const { return diameter + rate * time; }
    Real diameter_squared(Pair<Real> const&, Real time) const {
        return diameter_at(time) * diameter_at(time);
    }

    /// A search has to find neighbours up to the end of the growth.
    System as_searched(System system) const {
        system.diameter = static_cast<double>(widest);
        return system;
    }

    /// The first root of |r + v t| = diameter(t). Balls that grow faster than they part meet again.
    template <class Number>
    [[gnu::always_inline]] Number contact_time(Pair<Number> const& p) const {
        Number const zero{};
        Number const never = zero + std::numeric_limits<Real>::quiet_NaN();
        Number const reach = p.time * rate + diameter;
        Number const a = p.vx * p.vx + p.vy * p.vy + p.vz * p.vz - rate * rate;
        Number const b = p.x * p.vx + p.y * p.vy + p.z * p.vz - rate * reach;
        Number const c = p.x * p.x + p.y * p.y + p.z * p.z - reach * reach;
        Number const root = square_root(b * b - a * c);
        Number const closing = p.time + select(c > zero, c, zero) / (root - b);
        Number const overtaken = p.time - (b + root) / a;
        // An overlap that closes is a contact at once, whatever its root.
        Number const soon = select(c > zero, closing, p.time);
        return select(b < zero, soon, select(a < zero, overtaken, never));
    }

    WallContact<Real> wall_contact(Ball<Real> const& ball, PeriodicCube<Real> const&) const {
        (void)ball;
        return {};
    }

    WallContact<Real> wall_contact(Ball<Real> const& ball, WalledCube<Real> const& cube) const {
        WallContact<Real> best;
        for (std::int32_t d = 0; d < 3; ++d) {
            for (int const towards : {-1, 1}) {
                Real const closing = towards * ball.velocity[d] + rate / 2;
                if (!(closing > 0)) continue;
                Real const gap =
                    towards * (plane(cube, towards, ball.time, ball.velocity[d]) - ball.point[d]);
                Real const time = gap > 0 ? ball.time + gap / closing : ball.time;
                if (time < best.time) best = {time, 2 * d + (towards > 0 ? 1 : 0)};
            }
        }
        return best;
    }

    /// The planes that stop the centres close in as the balls grow.
    Real plane(WalledCube<Real> const& cube, int towards, Real time, Real /*component*/) const {
        Real const grown = rate * time / 2 + (diameter - cube.diameter) / 2;
        return towards < 0 ? cube.low + grown : cube.high - grown;
    }

    /// The normal components are exchanged in the frame of the growing surfaces.
    Vector3<Real> collide(Vector3<Real>& velocity_i, Vector3<Real>& velocity_j,
                          Vector3<Real> const& separation, std::uint64_t) const {
        using std::sqrt;
        Real const distance = sqrt(dot<Real>(separation, separation));
        Vector3<Real> const normal = separation / distance;
        Real const closing = rate - dot<Real>(normal, velocity_j - velocity_i);
        if (!(closing > 0)) return Vector3<Real>::Zero();
        // A little more than the exact kick, so that rounding cannot leave the pair closing.
        Vector3<Real> kick = normal * (closing + rate / (1 << 20));
        velocity_i -= kick;
        velocity_j += kick;
        return kick;
    }

    Real reflect(Real component, int towards) const { return -component - towards * rate; }
    Real expiry(Real when) const { return when; }
    void begin_epoch(Real length) { diameter += rate * length; }
};

} // namespace clack
