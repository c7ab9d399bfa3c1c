#pragma once
// The model that nearly every scene needs: equal elastic balls of steady size. Mutants under test
// are this struct with one rule exchanged.

#include "prediction/contact.hpp"
#include "prediction/wall.hpp"
#include "resolution/bounce.hpp"
#include "state/system.hpp"

#include <cstdint>

namespace clack {

template <class Real> struct ElasticBalls : SteadyDiameter<Real> {
    explicit ElasticBalls(System const& system)
        : SteadyDiameter<Real>(static_cast<Real>(system.diameter)) {}

    static constexpr bool keeps_energy = true;

    /// The squared distance at which a pair collides.
    Real diameter_squared(Pair<Real> const& /*pair*/, Real /*time*/) const { return this->squared; }

    /// The system as a search for neighbours should take it.
    System as_searched(System const& system) const { return system; }

    template <class Container>
    WallContact<Real> wall_contact(Ball<Real> const& ball, Container const& cube) const {
        return earliest_wall(ball, cube);
    }

    /// Changes the two velocities; returns the momentum per unit mass given to j.
    [[gnu::always_inline]] Vector3<Real> collide(Vector3<Real>& velocity_i,
                                                 Vector3<Real>& velocity_j,
                                                 Vector3<Real> const& separation,
                                                 std::uint64_t /*collision*/) const {
        return exchange_normal_velocities(velocity_i, velocity_j, separation);
    }

    /// The plane that stops a ball's centre; `towards` is -1 or 1, `component` that of the velocity
    /// along the wall's normal.
    Real plane(WalledCube<Real> const& cube, int towards, Real /*time*/, Real /*component*/) const {
        return towards < 0 ? cube.low : cube.high;
    }

    /// The component of a velocity along a wall's normal, after the wall.
    Real reflect(Real component, int /*towards*/) const { return -component; }

    /// What a search's expiry becomes: itself.
    Real expiry(Real when) const { return when; }

    void begin_epoch(Real) {}
};

} // namespace clack
