#pragma once
// Time that does not wear out: a whole number of epochs and an offset.

#include "state/real.hpp"

#include <cmath>
#include <cstdint>

namespace clack {

/// Time = epoch * length + offset with length a power of two, so the offset alone, which is what
/// collisions are computed with, is as precise at 1e12 as at 0.
template <class Real> struct Clock {
    double length = 1; // of an epoch, a power of two  [time]
    std::int64_t epoch = 0;
    Real offset = 0;

    double time() const { return time_at(offset); }
    double time_at(Real when) const {
        return static_cast<double>(static_cast<Real>(epoch) * static_cast<Real>(length) + when);
    }
};

/// A moment as clocks count it; beyond any run when the time is infinite.
template <class Real> Clock<Real> moment(double time, double epoch_length) {
    constexpr double epochs_max = 0x1p62;
    double const epochs = std::floor(time / epoch_length);
    if (!(epochs < epochs_max)) return {epoch_length, static_cast<std::int64_t>(epochs_max), 0};
    return {epoch_length, static_cast<std::int64_t>(epochs),
            static_cast<Real>(time - epochs * epoch_length)};
}

} // namespace clack
