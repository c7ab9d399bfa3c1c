#pragma once
// A ball is one record of straight flight.

#include "state/real.hpp"

namespace clack {

/// x(t) = point + velocity (t - time). Written by a collision and by a change of epoch, by nothing
/// else. `time` counts from the start of the epoch. Eight numbers wide, so that a double record is
/// one cache line: a neighbour costs one load.
template <class Real> struct alignas(8 * sizeof(Real)) Ball {
    Vector3<Real> point = Vector3<Real>::Zero();    // where the flight began  [length]
    Vector3<Real> velocity = Vector3<Real>::Zero(); // [length / time]
    Real time = 0;                                  // when the flight began

    Vector3<Real> position(Real when) const { return point + velocity * (when - time); }
};

} // namespace clack
