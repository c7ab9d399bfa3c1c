#pragma once
// A ball is one record of straight flight.

#include "state/real.hpp"

#include <array>
#include <cstddef>

namespace clack {

/// Four numbers at a time: half a record.
template <class Real> struct FourTypes;
template <> struct FourTypes<float> {
    using Numbers [[gnu::vector_size(16)]] = float;
    using InMemory [[gnu::vector_size(16), gnu::may_alias]] = float;
};
template <> struct FourTypes<double> {
    using Numbers [[gnu::vector_size(32)]] = double;
    using InMemory [[gnu::vector_size(32), gnu::may_alias]] = double;
};
template <class Real> using Fours = typename FourTypes<Real>::Numbers;

/// Four numbers of whatever begins at an address that is aligned for them. At once: without
/// AVX-512 g++ 12 copies a double's four in two pieces, and what reads them whole has to wait.
template <class Real> auto& fours_at(void* address) {
    return *static_cast<typename FourTypes<Real>::InMemory*>(address);
}
template <class Real> Fours<Real> fours_at(void const* address) {
    return *static_cast<typename FourTypes<Real>::InMemory const*>(address);
}

/// Two numbers at a time.
using Twos [[gnu::vector_size(2 * sizeof(double))]] = double;

/// x + y + z of two fours, side by side.
[[gnu::always_inline]] inline Twos sums_of_three(Fours<double> a, Fours<double> b) {
    auto const evens = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    auto const odds = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    return __builtin_shufflevector(evens, evens, 0, 1) + __builtin_shufflevector(odds, odds, 0, 1) +
           __builtin_shufflevector(evens, evens, 2, 3);
}

/// x(t) = point + velocity (t - time). Written by a collision and by a change of epoch, by nothing
/// else; `note` is no part of the flight. `time` counts from the start of the epoch. Eight numbers
/// wide, so that a double record is one cache line: a neighbour costs one load.
template <class Real> struct alignas(8 * sizeof(Real)) Ball {
    Vector3<Real> point = Vector3<Real>::Zero();    // where the flight began  [length]
    Real time = 0;                                  // when the flight began
    Vector3<Real> velocity = Vector3<Real>::Zero(); // [length / time]
    Real note = infinity<Real>; // when it means to touch something, or what its model keeps there

    Vector3<Real> position(Real when) const { return point + velocity * (when - time); }
};

/// A record's two halves: the point and when the flight began, the velocity and the note.
template <class Real> Fours<Real> point_and_time(Ball<Real> const& ball) {
    return fours_at<Real>(static_cast<void const*>(&ball));
}
template <class Real> Fours<Real> velocity_four(Ball<Real> const& ball) {
    return fours_at<Real>(reinterpret_cast<char const*>(&ball) + sizeof(Fours<Real>));
}
template <class Real> void set_point_and_time(Ball<Real>& ball, Fours<Real> const& four) {
    fours_at<Real>(static_cast<void*>(&ball)) = four;
}

template <class Real>
void set_velocity_and_note(Ball<Real>& ball, Vector3<Real> const& velocity, Real note) {
    if constexpr (has_lanes<Real>) {
        // At once: what is soon read as one would otherwise wait for all four to be written.
        fours_at<Real>(reinterpret_cast<char*>(&ball) + sizeof(Fours<Real>)) =
            Fours<Real>{velocity[0], velocity[1], velocity[2], note};
    } else {
        ball.velocity = velocity;
        ball.note = note;
    }
}

/// For indexes, which need no more than double of any type's records.
template <class Real> Fours<double> in_double(Vector3<Real> const& x) {
    Fours<double> four{};
    for (int d = 0; d < 3; ++d) four[d] = static_cast<double>(x[d]);
    return four;
}
inline Fours<double> in_double(std::array<float, 4> const& x) { // in one instruction
    Fours<double> four;
    for (std::size_t k = 0; k < 4; ++k) four[k] = static_cast<double>(x[k]);
    return four;
}
template <class Real> Fours<double> point_in_double(Ball<Real> const& ball) {
    if constexpr (std::is_same_v<Real, double>) {
        return point_and_time(ball);
    } else {
        return in_double(ball.point);
    }
}
template <class Real> Fours<double> velocity_in_double(Ball<Real> const& ball) {
    if constexpr (std::is_same_v<Real, double>) {
        return velocity_four(ball);
    } else {
        return in_double(ball.velocity);
    }
}

} // namespace clack
