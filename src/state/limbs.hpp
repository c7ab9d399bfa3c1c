#pragma once
// Any floating number as doubles that add up to it, for files that know no other type.

#include "state/real.hpp"

#include <vector>

namespace clack {

/// Writes limb_count<Real> doubles whose exact sum is x, and returns where the next would stand.
template <class Real> double* write_limbs(Real x, double* limbs) {
    for (int limb = 0; limb < limb_count<Real>; ++limb) {
        auto const rounded = static_cast<double>(x);
        *limbs++ = rounded;
        x -= static_cast<Real>(rounded);
    }
    return limbs;
}

/// The number that starts at `position`, which moves on behind it. Smallest limbs are added first,
/// so every sum is exact.
template <class Real> Real take_limbs(std::vector<double> const& limbs, std::size_t& position) {
    Real x = 0;
    for (auto limb = static_cast<std::size_t>(limb_count<Real>); limb-- > 0;)
        x += static_cast<Real>(limbs.at(position + limb));
    position += static_cast<std::size_t>(limb_count<Real>);
    return x;
}

} // namespace clack
