#pragma once
// What one collision did: the record that observables, files and hashes eat.

#include "state/real.hpp"

#include <cstdint>

namespace clack {

enum class CollisionKind : std::int8_t { ball = 1, wall = 2 };

/// One collision, as it left the balls.
template <class Real> struct Collision {
    CollisionKind kind;
    std::int64_t epoch;  // whole epochs of the clock
    Real offset;         // clock within the epoch: time = epoch * epoch_length + offset
    double time;         // since the run's time 0, rounded
    std::int64_t first;  // number of the ball (ball-ball: the lower number)
    std::int64_t second; // number of the other ball, or of the wall: 0..5 = x-, x+, y-, y+, z-, z+
    Vector3<Real> velocity_first;  // outgoing
    Vector3<Real> velocity_second; // outgoing; zero for a wall
    Vector3<Real> position;        // centre of the first ball at contact
    Vector3<Real> separation;      // centre of the second minus centre of the first; for a wall the
                              // vector from the centre to the plane it reached is not kept: zero
    Vector3<Real> impulse; // momentum given to the second ball, or to the wall

    /// The same in double, for observers that do not care.
    template <class Other> Collision<Other> cast() const {
        return {kind,
                epoch,
                static_cast<Other>(offset),
                time,
                first,
                second,
                velocity_first.template cast<Other>(),
                velocity_second.template cast<Other>(),
                position.template cast<Other>(),
                separation.template cast<Other>(),
                impulse.template cast<Other>()};
    }
};

} // namespace clack
