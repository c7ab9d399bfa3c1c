#pragma once
// The floating types that a run can be made in, and the few operations that fix its bits.

#include <boost/multiprecision/float128.hpp>

#include <Eigen/Core>
#include <boost/multiprecision/eigen.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace clack {

/// IEEE binary128: the oracle that the other precisions are measured against.
using quad = boost::multiprecision::float128;

/// A place, a velocity or a separation in three dimensions.
template <class Real> using Vector3 = Eigen::Matrix<Real, 3, 1>;

template <class Real> inline Real const unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;
template <class Real> inline Real const infinity = std::numeric_limits<Real>::infinity();

/// float and double have vector units; the wider types go one by one.
template <class Real>
constexpr bool has_lanes = std::is_same_v<Real, float> || std::is_same_v<Real, double>;

/// How many doubles add up to any value of this type without loss: 1 for float and double,
/// 2 for an 80-bit long double, 3 for quad.
template <class Real> constexpr int limb_count = (std::numeric_limits<Real>::digits + 52) / 53;

/// a . b, added from left to right. Eigen chooses an order by the vector unit it finds; the bits of
/// a run must not depend on that.
template <class Real> Real dot(Vector3<Real> const& a, Vector3<Real> const& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The nearest whole number, halves to even: odd, nearest(-x) == -nearest(x). By the rounding of an
/// addition, which is exact while |x| < 2^(digits - 2), which no box reaches; many at a time by the
/// one instruction that vector units have for it, to the same bits but for the sign of zero.
template <class Number, class Real = Number>
[[gnu::always_inline]] inline Number nearest_integer(Number x) {
#ifdef __SSE4_1__
    if constexpr (!std::is_same_v<Number, Real>) {
        Number whole;
        for (std::size_t lane = 0; lane < sizeof x / sizeof(Real); ++lane)
            whole[lane] = std::nearbyint(x[lane]);
        return whole;
    }
#endif
    Real const shift = 3 / (2 * std::numeric_limits<Real>::epsilon()); // 1.5 2^(digits - 1)
    return (x + shift) - shift;
}

} // namespace clack
