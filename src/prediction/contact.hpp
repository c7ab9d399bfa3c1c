#pragma once
// When two balls will touch.

#include "prediction/lanes.hpp"
#include "state/container.hpp"

#include <cmath>
#include <limits>

namespace clack {

/// A pair as its two records give it at the later of their two times: separation and relative
/// velocity, j minus i. One pair, or one a lane.
template <class Number> struct Pair {
    Number x, y, z, vx, vy, vz;
    Number time;
};

/// The balls of the model that nearly every scene needs: their diameter does not change.
template <class Real> struct SteadyDiameter {
    static constexpr bool grows = false;

    Real squared;
    Real near;                 // of c below, where the pair is three diameters apart
    bool expects_near = false; // whether most candidates are nearer; it changes no bit

    explicit SteadyDiameter(Real diameter) : squared(diameter * diameter), near(8 * squared) {}

    /// When the pair touches; NaN when it never does, so that no comparison finds it earliest.
    /// An overlapping pair that approaches touches at once, one that recedes never does.
    /// The root is c / (-b + sqrt(disc)), which subtracts no near-equal numbers. The discriminant
    /// is b^2 - v.v c for near pairs and v.v d^2 - |r x v|^2 for the others. In units of v.v d^2
    /// the first loses (r/d)^2 roundings and agrees with the root to the last digit at contact; the
    /// second loses 2 r/d.
    template <class Number>
    [[gnu::always_inline]] Number contact_time(Pair<Number> const& p) const {
        Number const zero{};
        Number never = zero + std::numeric_limits<Real>::quiet_NaN();
        Number const b = p.x * p.vx + p.y * p.vy + p.z * p.vz;
        if constexpr (!is_lanes<Number>) {
            if (!(b < 0)) return never;
        }
        Number const c = p.x * p.x + p.y * p.y + p.z * p.z - squared;
        Number const speed2 = p.vx * p.vx + p.vy * p.vy + p.vz * p.vz;
        Number disc = b * b - speed2 * c, way = c;
        if (!all_near(b, c)) {
            disc = select(c < near, disc, speed2 * squared - cross_squared(p));
            if constexpr (!is_lanes<Number>) {
                if (c > zero && disc < zero) return never;
            }
            disc = select(c > zero, disc, b * b);
            way = select(c > zero, c, zero);
        }
        // In lanes a negative discriminant makes a NaN that goes through to the end.
        Number const when = p.time + way / (square_root(disc) - b);
        return select(b < zero, when, never);
    }

private:
    /// |r x v|^2
    template <class Number>
    [[gnu::always_inline]] static Number cross_squared(Pair<Number> const& p) {
        Number const x = p.y * p.vz - p.z * p.vy;
        Number const y = p.z * p.vx - p.x * p.vz;
        Number const z = p.x * p.vy - p.y * p.vx;
        return x * x + y * y + z * z;
    }

    /// Whether all pairs that approach are near and do not overlap, which spares a sixth of the
    /// vector instructions. Measured at packing fractions 0.20 and 0.49: 1.04 and 1.06 times as
    /// fast, without AVX-512 1.08 at 0.49.
    template <class Number>
    [[gnu::always_inline]] bool all_near(Number const& b, Number const& c) const {
        if constexpr (is_lanes<Number>) {
            Number const zero{}, end = zero + near;
            std::uint32_t const usual = bits_of_less(c, end) & ~bits_of_less(c, zero);
            return expects_near && (bits_of_less(b, zero) & ~usual) == 0;
        } else {
            return false;
        }
    }
};

/// The pair of two records, through the image that is nearest at time `now` (any moment since both
/// records hold, at which the pair is nearer than half a side, gives the same image).
template <class Real, class Container>
[[gnu::always_inline]] inline Pair<Real> pair_of(Ball<Real> const& i, Ball<Real> const& j,
                                                 Container const& cube, Real now) {
    Real const time = later(i.time, j.time);
    Real const flown_i = time - i.time, flown_j = time - j.time;
    if constexpr (has_lanes<Real>) {
        // The three components at once, and a fourth that means nothing.
        Fours<Real> const vi = velocity_four(i), vj = velocity_four(j), v = vj - vi;
        Fours<Real> r = (point_and_time(j) + vj * flown_j) - (point_and_time(i) + vi * flown_i);
        if constexpr (Container::boundary == Boundary::periodic)
            r = r - cube.image(r + v * (now - time)) * cube.side;
        return {r[0], r[1], r[2], v[0], v[1], v[2], time};
    } else {
        auto const velocity = [&](int d) { return j.velocity[d] - i.velocity[d]; };
        auto const apart = [&](int d) {
            Real r =
                (j.point[d] + j.velocity[d] * flown_j) - (i.point[d] + i.velocity[d] * flown_i);
            if constexpr (Container::boundary == Boundary::periodic) {
                return r - cube.image(r + velocity(d) * (now - time)) * cube.side;
            } else {
                return r;
            }
        };
        return {apart(0), apart(1), apart(2), velocity(0), velocity(1), velocity(2), time};
    }
}

/// The same bits for two records that have just been written at one moment, sooner: all that a
/// collision does waits for it. Measured with lists, and with a quotient in `resolution/bounce.hpp`
/// that waits for one division instead of two: 1.02 to 1.04 times as fast.
template <class Real, class Container>
[[gnu::always_inline]] inline Pair<Real> pair_now(Ball<Real> const& i, Ball<Real> const& j,
                                                  Container const& cube) {
    if constexpr (has_lanes<Real>) {
        Fours<Real> const v = velocity_four(j) - velocity_four(i);
        Fours<Real> r = point_and_time(j) - point_and_time(i);
        if constexpr (Container::boundary == Boundary::periodic) r = r - cube.image(r) * cube.side;
        return {r[0], r[1], r[2], v[0], v[1], v[2], i.time};
    } else {
        return pair_of(i, j, cube, i.time);
    }
}

} // namespace clack
