#pragma once
// The cube: hard walls, or space that repeats itself.

#include "state/ball.hpp"
#include "state/system.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace clack {

/// A cube with six hard walls. What it holds is the room of the centres: half a diameter short of
/// the walls on each side.
template <class Real> struct WalledCube {
    static constexpr Boundary boundary = Boundary::walls;

    Real diameter; // of the balls that the planes are for
    Real low, high;

    explicit WalledCube(System const& system)
        : diameter(static_cast<Real>(system.diameter)), low(static_cast<Real>(system.diameter) / 2),
          high(static_cast<Real>(system.side) - static_cast<Real>(system.diameter) / 2) {}

    Real origin() const { return low; }
    Real extent() const { return high - low; }

    /// Nothing repeats, so nothing is wrapped.
    std::array<std::int32_t, 3> wrap(Vector3<Real>&) const { return {0, 0, 0}; }
};

/// A cube that repeats itself in every direction.
template <class Real> struct PeriodicCube {
    static constexpr Boundary boundary = Boundary::periodic;

    Real side, inverse_side;

    explicit PeriodicCube(System const& system)
        : side(static_cast<Real>(system.side)), inverse_side(1 / static_cast<Real>(system.side)) {}

    Real origin() const { return 0; }
    Real extent() const { return side; }

    /// How many sides away the nearest image is, for one component of a separation.
    template <class Number> [[gnu::always_inline]] Number image(Number distance) const {
        return nearest_integer<Number, Real>(distance * inverse_side);
    }

    bool holds(Vector3<Real> const& place) const {
        return std::min(std::min(place[0], place[1]), place[2]) >= 0 &&
               std::max(std::max(place[0], place[1]), place[2]) < side;
    }

    /// Brings a place back into [0, side] and tells how many sides it had left it by.
    std::array<std::int32_t, 3> wrap(Vector3<Real>& place) const {
        std::array<std::int32_t, 3> laps{};
        for (int d = 0; d < 3; ++d) {
            if (place[d] >= 0 && place[d] < side) continue;
            using std::floor;
            Real const lap = floor(place[d] * inverse_side);
            place[d] -= lap * side;
            if (place[d] < 0) place[d] = 0; // the quotient rounded up to the next whole number
            laps[static_cast<std::size_t>(d)] = static_cast<std::int32_t>(lap);
        }
        return laps;
    }
};

} // namespace clack
