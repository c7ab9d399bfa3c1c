#pragma once
// What a collision does to the balls.

#include "prediction/contact.hpp"
#include "state/ball.hpp"

namespace clack {

/// Two equal balls in contact exchange the components of their velocities along the line of their
/// centres, as it is at contact: dividing by r.r rather than by d^2 keeps energy to rounding.
/// Returns the momentum per unit mass given to j. `share` is 1 but for a mutant under test.
///
/// Afterwards the pair must recede in the very arithmetic of the next prediction, or it would
/// collide again and again without moving: where rounding left it approaching, the smallest
/// impulses that change the velocities are added until it does not.
template <class Real>
Vector3<Real> exchange_normal_velocities(Vector3<Real>& velocity_i, Vector3<Real>& velocity_j,
                                         Vector3<Real> const& separation, Real share = 1) {
    Real const approach = dot<Real>(separation, velocity_j - velocity_i);
    if (!(approach < 0)) return Vector3<Real>::Zero();
    Real const distance2 = dot<Real>(separation, separation);
    Vector3<Real> const kick = separation * (share * approach / distance2);
    velocity_i += kick;
    velocity_j -= kick;

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
    return -kick;
}

} // namespace clack
