#pragma once
// What a collision does to the balls.

#include "prediction/contact.hpp"
#include "state/ball.hpp"

#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>

namespace clack {

/// a b + c, rounded once where the type can: correctly on every machine, in hardware or not.
template <class Real> Real fused(Real a, Real b, Real c) {
    if constexpr (std::is_floating_point_v<Real>) {
        return std::fma(a, b, c);
    } else {
        return a * b + c;
    }
}

/// What dot(r, r) lost to rounding.
template <class Real> [[gnu::always_inline]] inline Real square_rest(Vector3<Real> const& r) {
    Real const xx = r[0] * r[0], yy = r[1] * r[1], zz = r[2] * r[2];
    auto const lost = [](Real a, Real b) { // by a + b: D. E. Knuth's two-sum
        Real const sum = a + b, second = sum - a;
        return (a - (sum - second)) + (b - second);
    };
    Real const products = fused(r[0], r[0], -xx) + fused(r[1], r[1], -yy) + fused(r[2], r[2], -zz);
    return products + lost(xx, yy) + lost(xx + yy, zz);
}

/// After a collision the pair must recede in the very arithmetic of the next prediction, or it
/// would collide again and again without moving: where rounding left it approaching, the smallest
/// impulses that change the velocities are added until it does not.
template <class Real>
[[gnu::noinline, gnu::cold]] std::pair<Vector3<Real>, Vector3<Real>>
turn_apart(Vector3<Real> velocity_i, Vector3<Real> velocity_j, Vector3<Real> separation,
           Real distance2) {
    Real speed = 0;
    for (int d = 0; d < 3; ++d) {
        using std::abs;
        speed = later<Real>(speed, later<Real>(abs(velocity_i[d]), abs(velocity_j[d])));
    }
    using std::sqrt;
    Real nudge = unit_roundoff<Real> * speed / sqrt(distance2);
    while (dot<Real>(separation, velocity_j - velocity_i) < 0) {
        velocity_i -= separation * nudge;
        velocity_j += separation * nudge;
        nudge *= 2;
    }
    return {velocity_i, velocity_j};
}

/// Two equal balls in contact exchange the components of their velocities along the line of their
/// centres, as it is at contact: dividing by r.r rather than by d^2 keeps energy to rounding.
/// Returns the momentum per unit mass given to j. `share` is 1 but for a mutant under test.
///
/// The quotient of approach and distance2 keeps its remainder. In contact distance2 takes but a few
/// values about the diameter squared, by which quotients round up more often than down: without the
/// remainder the energy of balls of diameter 1 rose by a tenth of a rounding a collision.
template <class Real>
[[gnu::always_inline]] inline Vector3<Real>
exchange_normal_velocities(Vector3<Real>& velocity_i, Vector3<Real>& velocity_j,
                           Vector3<Real> const& separation, Real share = 1) {
    Real const approach = dot<Real>(separation, velocity_j - velocity_i);
    if (!(approach < 0)) return Vector3<Real>::Zero();
    Real const distance2 = dot<Real>(separation, separation);
    Real const ratio = share * approach / distance2;
    Real const inverse = 1 / distance2; // the ratio does not wait for it, nor the rest for long
    Real const rest =
        (fused(-ratio, distance2, share * approach) - ratio * square_rest(separation)) * inverse;
    Vector3<Real> kick;
    for (int d = 0; d < 3; ++d) kick[d] = fused(separation[d], ratio, separation[d] * rest);
    velocity_i += kick;
    velocity_j -= kick;

    if (dot<Real>(separation, velocity_j - velocity_i) < 0)
        std::tie(velocity_i, velocity_j) =
            turn_apart<Real>(velocity_i, velocity_j, separation, distance2);
    return -kick;
}

} // namespace clack
