#pragma once
// How fine a picture may be, so that it comes in time.

#include "view/canvases.hpp"

#include <algorithm>

namespace clack::view {

/// Learns from how long pictures took. One that answers a hand may be coarser than a window has
/// pixels, for the blink that it stands; what merely moves on by itself may not.
class Fineness {
public:
    float for_hand() const { return in_motion_; }
    float for_time() const { return std::max(in_motion_, 1.f); }

    void took(float fineness, double seconds) {
        constexpr double quick = 0.005, slow = 0.020; // [s]
        if (fineness <= in_motion_ && seconds > slow)
            in_motion_ = std::max(in_motion_ / 2, coarsest);
        if (fineness >= in_motion_ && seconds < quick)
            in_motion_ = std::min(in_motion_ * 2, finest);
    }

private:
    float in_motion_ = 1;
};

} // namespace clack::view
