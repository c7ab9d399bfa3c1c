#pragma once
// The floating types that a run can be made in, and what the rest of the code asks of them.

#include <boost/multiprecision/float128.hpp>

#include <Eigen/Core>
#include <boost/multiprecision/eigen.hpp>

#include <limits>

namespace clack {

/// IEEE binary128: the oracle that the other precisions are measured against.
using quad = boost::multiprecision::float128;

/// A place, a velocity or a separation in three dimensions.
template <class Real> using Vector3 = Eigen::Matrix<Real, 3, 1>;

template <class Real> constexpr Real unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;
template <class Real> constexpr Real infinity = std::numeric_limits<Real>::infinity();

/// How many doubles add up to any value of this type without loss: 1 for float and double,
/// 2 for an 80-bit long double, 3 for quad.
template <class Real> constexpr int limb_count = (std::numeric_limits<Real>::digits + 52) / 53;

} // namespace clack
