#pragma once
// The larger of two errors.

#include <cmath>

namespace clack::validation {

/// Not a number where one of them is none, so that nothing passes because it could not be judged.
inline double worse(double const a, double const b) { return std::isnan(a) || a >= b ? a : b; }

} // namespace clack::validation
