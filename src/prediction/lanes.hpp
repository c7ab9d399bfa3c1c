#pragma once
// Eight numbers at a time, in the vector types of g++ and clang++: on a machine with narrower
// registers the compiler splits them, and the bits stay the same.

#include "state/ball.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace clack {

constexpr int lane_count = 8;

/// float and double have vector units; the wider types go one by one.
template <class Real>
constexpr bool has_lanes = std::is_same_v<Real, float> || std::is_same_v<Real, double>;

template <class Real> struct LaneTypes;
template <> struct LaneTypes<float> {
    using Numbers [[gnu::vector_size(lane_count * sizeof(float))]] = float;
    using Integers [[gnu::vector_size(lane_count * sizeof(float))]] = std::int32_t;
};
template <> struct LaneTypes<double> {
    using Numbers [[gnu::vector_size(lane_count * sizeof(double))]] = double;
    using Integers [[gnu::vector_size(lane_count * sizeof(double))]] = std::int64_t;
};
template <class Real> using Lanes = typename LaneTypes<Real>::Numbers;
template <class Real> using LaneIntegers = typename LaneTypes<Real>::Integers;

template <class Number>
constexpr bool is_lanes =
    std::is_same_v<Number, Lanes<float>> || std::is_same_v<Number, Lanes<double>>;

// The same three words for one number and for eight, so that one source serves both.
template <class Number> inline Number square_root(Number x) {
    using std::sqrt;
    if constexpr (is_lanes<Number>) {
        Number root;
        for (int lane = 0; lane < lane_count; ++lane) root[lane] = sqrt(x[lane]);
        return root;
    } else {
        return sqrt(x);
    }
}
template <class Condition, class Number>
inline Number select(Condition condition, Number yes, Number no) {
    return condition ? yes : no;
}
template <class Number> inline Number later(Number a, Number b) { return select(a > b, a, b); }

template <class Real> inline Lanes<Real> broadcast(Real x) {
    return Lanes<Real>{x, x, x, x, x, x, x, x};
}

/// The records of eight balls, turned: one vector a component.
template <class Real> struct BallLanes { Lanes<Real> x, y, z, vx, vy, vz, time; };

template <class Real>
inline BallLanes<Real> load_balls(Ball<Real> const* balls, std::int32_t const* chosen) {
    using V = Lanes<Real>;
    V row[lane_count];
    for (int lane = 0; lane < lane_count; ++lane) {
        std::memcpy(&row[lane], static_cast<void const*>(&balls[chosen[lane]]), sizeof(V));
    }
    // Three rounds of pairwise exchange transpose the 8 x 8 block.
    V a[8], b[8];
    for (int k = 0; k < 4; ++k) {
        a[2 * k] = __builtin_shufflevector(row[2 * k], row[2 * k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        a[2 * k + 1] =
            __builtin_shufflevector(row[2 * k], row[2 * k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int half = 0; half < 8; half += 4) {
        for (int k = half; k < half + 2; ++k) {
            b[k] = __builtin_shufflevector(a[k], a[k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
            b[k + 2] = __builtin_shufflevector(a[k], a[k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
        }
    }
    auto const low = [&](int k) {
        return __builtin_shufflevector(b[k], b[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    };
    auto const high = [&](int k) {
        return __builtin_shufflevector(b[k], b[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    };
    return {low(0), low(1), low(2), low(3), high(0), high(1), high(2)};
}

} // namespace clack
