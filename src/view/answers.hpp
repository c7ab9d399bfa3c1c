#pragma once
// How long a person waits.

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <utility>

namespace clack::view {

/// From what was asked with hand or key to the picture that shows it.
class Answers {
public:
    using Clock = std::chrono::steady_clock;

    void ask(Clock::time_point now) {
        waiting_.push_back(now);
        latest_ = now;
        ++asked_;
    }
    std::uint64_t asked() const { return asked_; }
    Clock::time_point latest() const { return latest_; } // that something was asked

    /// The window now shows what the first so many asked for.
    void answer(std::uint64_t shown, Clock::time_point now) {
        for (; asked_ - waiting_.size() < shown; waiting_.pop_front()) {
            double const wait = std::chrono::duration<double>(now - waiting_.front()).count();
            longest_ = std::max(longest_, wait);
        }
    }
    /// Since this was last asked  [s]
    double longest() { return std::exchange(longest_, 0); }

private:
    std::deque<Clock::time_point> waiting_;
    Clock::time_point latest_;
    std::uint64_t asked_ = 0;
    double longest_ = 0;
};

} // namespace clack::view
