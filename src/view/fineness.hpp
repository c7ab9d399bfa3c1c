#pragma once
// How fine a picture may be, and how many balls a draft may have, so that it comes in time.

#include "view/canvases.hpp"

#include <algorithm>
#include <cstddef>

namespace clack::view {

/// Learns from how long pictures took. One that answers a hand may be coarser than a window has
/// pixels, for the blink that it stands; what merely moves on by itself may not.
class Fineness {
public:
    float for_hand() const { return in_motion_; }
    float for_time() const { return std::max(in_motion_, 1.f); }

    std::size_t balls_of_draft() const { return balls_of_draft_; }

    /// A picture, to choose its balls and to draw them. When the coarsest is slow, drafts have
    /// fewer balls; when it is quick, first they have more again.
    void took(float fineness, double seconds) {
        constexpr double quick = 0.005, slow = 0.020; // [s]
        if (fineness <= in_motion_ && seconds > slow) {
            if (in_motion_ > coarsest)
                in_motion_ /= 2;
            else
                balls_of_draft_ = std::max(balls_of_draft_ / 2, fewest);
        } else if (fineness >= in_motion_ && seconds < quick) {
            if (balls_of_draft_ < most)
                balls_of_draft_ *= 2;
            else
                in_motion_ = std::min(in_motion_ * 2, finest);
        }
    }

private:
    static constexpr std::size_t most = 20'000, fewest = most / 8;

    float in_motion_ = 1;
    std::size_t balls_of_draft_ = most;
};

} // namespace clack::view
