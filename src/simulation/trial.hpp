#pragma once
// Whether a helper is worth having, found by going without it now and then.

#include <algorithm>
#include <limits>

namespace clack {

/// Work is timed in slices of equal size. Every `period` slices the other way, with the helper or
/// without it, is tried: a slice to get under way, then `tries` that count. Their best beside the
/// best of as many before: who else is on the machine for a moment does not count.
/// Why: on two cores that are shared with strangers, a second thread that had made a run 1.5 times
/// as fast made it 0.65 times as fast.
class Trial {
public:
    static constexpr int period = 128, tries = 3;
    static constexpr double clearly = 0.97; // of the other's time: less is no reason to change

    /// Whether the helper works in the slice that is under way.
    bool helps() const { return helps_ != is_trial(); }

    /// A slice has taken so long.
    void slice_done(double seconds) {
        double& best = is_trial() ? other_ : own_;
        bool const counts = place_ >= period - 2 * tries - 1 && place_ != period - tries - 1;
        if (counts) best = std::min(best, seconds);
        if (++place_ < period) return;
        if (other_ < clearly * own_) helps_ = !helps_;
        own_ = other_ = std::numeric_limits<double>::infinity();
        place_ = 0;
    }

private:
    bool is_trial() const { return place_ >= period - tries - 1; }

    bool helps_ = true;
    int place_ = period / 2; // in the period: the first trial comes early
    double own_ = std::numeric_limits<double>::infinity(), other_ = own_;
};

} // namespace clack
