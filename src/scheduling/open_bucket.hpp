#pragma once
// The events of the bucket that is open, in order of time.

#include "scheduling/event_queue.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace clack {

/// A few events stand in a row, the earliest last: to insert one by one costs less than a heap's
/// jumps, which a processor cannot foretell. Many make a heap. Nothing is taken out before its
/// time: what no longer holds is dropped when it comes up.
template <class Real> class OpenBucket {
public:
    bool empty() const { return events_.empty(); }
    std::size_t size() const { return events_.size(); }
    std::int32_t upcoming(std::size_t places) const {
        return heaped_ || events_.size() <= places ? no_event
                                                   : events_[events_.size() - 1 - places].ball;
    }
    void clear() {
        events_.clear();
        heaped_ = false;
    }

    void insert(Real time, std::int32_t ball) {
        events_.push_back({time, ball});
        if (heaped_) {
            std::push_heap(events_.begin(), events_.end(), later_first);
        } else if (events_.size() > row_max) {
            std::make_heap(events_.begin(), events_.end(), later_first);
            heaped_ = true;
        } else {
            std::size_t place = events_.size() - 1;
            for (; place > 0 && events_[place - 1].time < time; --place)
                events_[place] = events_[place - 1];
            events_[place] = {time, ball};
        }
    }

    /// The ball whose event is first in the total order; no_event when none holds any more.
    std::int32_t earliest(NextEvents<Real> const& next) {
        for (; !events_.empty(); drop_first()) {
            std::int32_t const first =
                heaped_ ? first_at_top(next, 0, no_event) : first_in_row(next);
            if (first != no_event) return first;
        }
        clear();
        return no_event;
    }

    std::size_t bytes() const { return events_.capacity() * sizeof(Event); }

private:
    static constexpr std::size_t row_max = 64;

    struct Event {
        Real time;
        std::int32_t ball;
    };
    static bool later_first(Event const& a, Event const& b) { return a.time > b.time; }

    static bool holds(NextEvents<Real> const& next, Event const& event) {
        return next[event.ball].time() == event.time;
    }

    static bool same_collision(NextEvents<Real> const& next, std::int32_t a, std::int32_t b) {
        return next[a].partner == b && next.kind(a) == EventKind::ball &&
               next.kind(b) == EventKind::ball && next.mutual(a);
    }

    void drop_first() {
        if (heaped_) std::pop_heap(events_.begin(), events_.end(), later_first);
        events_.pop_back();
    }

    std::int32_t first_in_row(NextEvents<Real> const& next) const {
        Event const& last = events_.back();
        std::int32_t first = holds(next, last) ? last.ball : no_event;
        for (std::size_t k = events_.size() - 1; k > 0 && events_[k - 1].time == last.time; --k) {
            // The two of a collision, mostly: either stands for both.
            std::int32_t const ball = events_[k - 1].ball;
            if (first != no_event && same_collision(next, first, ball)) continue;
            if (holds(next, events_[k - 1]) && (first == no_event || next.precedes(ball, first)))
                first = ball;
        }
        return first;
    }

    /// A heap goes by time alone. Events as early as its top hang together below it; of those that
    /// hold, the first in the total order.
    std::int32_t first_at_top(NextEvents<Real> const& next, std::size_t k,
                              std::int32_t first) const {
        if (k >= events_.size() || events_[k].time != events_[0].time) return first;
        std::int32_t const ball = events_[k].ball;
        if (holds(next, events_[k]) && (first == no_event || next.precedes(ball, first)))
            first = ball;
        first = first_at_top(next, 2 * k + 1, first);
        return first_at_top(next, 2 * k + 2, first);
    }

    std::vector<Event> events_;
    bool heaped_ = false;
};

} // namespace clack
