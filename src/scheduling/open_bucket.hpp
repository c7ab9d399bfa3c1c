#pragma once
// The events of the bucket that is open, in order of time.

#include "prediction/lanes.hpp"
#include "scheduling/event_queue.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <vector>

namespace clack {

/// A few events stand in a row, the earliest first; many make a heap, in the total order: of
/// thousands that happen at one moment each is found at once. Nothing is taken out before its time:
/// what no longer holds is dropped when it comes up.
///
/// A bucket is opened at once: its events are written behind the row without a branch, and those
/// that count are put in order by how many are earlier.
template <class Real> class OpenBucket {
public:
    struct Event {
        Real time;
        std::int32_t ball;
    };

    OpenBucket() { clear(); }
    bool empty() const { return row_size() == 0 && heap_.empty(); }
    std::size_t size() const { return row_size() + heap_.size(); }
    /// The ball so many places behind the first, where that is known.
    std::int32_t upcoming(std::size_t places) const {
        return row_size() <= places ? no_event : row_[first_ + places].ball;
    }
    void clear() {
        clear_row();
        heap_.clear();
    }

    /// The next event of a ball.
    void insert(NextEvents<Real> const& next, std::int32_t ball) {
        if (!heap_.empty()) return insert_in_heap(next, ball);
        if (row_size() == row_max) return make_heap_with(next, ball);
        Real const time = next[ball].time();
        make_room(1);
        std::size_t place = end_++;
        for (; place > first_ && time < row_[place - 1].time; --place)
            row_[place] = row_[place - 1];
        row_[place] = {time, ball};
        row_[end_].time = infinity<Real>;
    }

    /// Events of a bucket that is being opened, none of which comes before one that is here: where
    /// to write them, `written` being there already. `append` then takes the first `count`.
    Event* room(std::size_t written, std::size_t more) {
        make_room(more, written);
        return row_.data() + end_;
    }
    void append(NextEvents<Real> const& next, std::size_t count) {
        if (row_size() + count > row_max || !heap_.empty()) {
            std::vector<Event> const many(row_.data() + end_, row_.data() + end_ + count);
            row_[end_].time = infinity<Real>;
            for (Event const& event : many) insert(next, event.ball);
            return;
        }
        put_in_order(row_.data() + end_, count);
        end_ += count;
        row_[end_].time = infinity<Real>;
    }

    /// The ball whose event is first in the total order; no_event when none holds any more.
    std::int32_t earliest(NextEvents<Real> const& next) {
        for (; row_[first_].time < infinity<Real>; ++first_) {
            Event const& event = row_[first_];
            if (row_[first_ + 1].time == event.time) {
                std::int32_t const ball = first_of_equals(next);
                if (ball != no_event) return ball;
            } else if (holds(next, event)) {
                return event.ball;
            }
        }
        for (; !heap_.empty(); drop_top()) {
            Ranked const& top = heap_.front();
            if (holds(next, top)) return top.ball;
        }
        return no_event;
    }

    std::size_t bytes() const {
        return row_.capacity() * sizeof(Event) + heap_.capacity() * sizeof(Ranked);
    }

private:
    static constexpr std::size_t row_max = 64;
    static constexpr std::size_t in_lanes_max = 32;

    struct Ranked : Event {
        typename NextEvents<Real>::Rank rank;
    };
    static bool later_first(Ranked const& a, Ranked const& b) {
        return a.time != b.time ? a.time > b.time : a.rank > b.rank;
    }

    std::size_t row_size() const { return end_ - first_; }
    void clear_row() {
        first_ = end_ = 0;
        if (row_.empty()) row_.resize(4 * row_max);
        row_[0].time = infinity<Real>;
    }

    /// Behind the row and what is written there, and for the event at infinity that ends it.
    void make_room(std::size_t more, std::size_t written = 0) {
        if (end_ + written + more < row_.size()) return;
        std::copy(row_.begin() + static_cast<std::ptrdiff_t>(first_),
                  row_.begin() + static_cast<std::ptrdiff_t>(end_ + std::max<std::size_t>(written, 1)),
                  row_.begin());
        end_ -= first_;
        first_ = 0;
        if (end_ + written + more >= row_.size()) row_.resize(2 * (end_ + written + more + 1));
    }

    /// Each goes behind those that are earlier, and of equal ones behind those that were before it.
    static void put_in_order(Event* events, std::size_t count) {
        if constexpr (has_lanes<Real>) {
            if (count <= in_lanes_max) return put_in_order_by_rank(events, count);
        }
        std::stable_sort(events, events + count,
                         [](Event const& a, Event const& b) { return a.time < b.time; });
    }

    /// How many are earlier is counted many at a time, without a branch: the steps of a sort cannot
    /// be foretold.
    static void put_in_order_by_rank(Event* events, std::size_t count) {
        constexpr std::size_t wide = lane_count;
        std::array<Event, in_lanes_max> copy;
        std::array<Lanes<Real>, in_lanes_max / wide> times;
        std::size_t const rows = (count + wide - 1) / wide;
        for (std::size_t k = 0; k < rows; ++k) times[k] = broadcast(infinity<Real>);
        for (std::size_t k = 0; k < count; ++k) {
            copy[k] = events[k];
            times[k / wide][k % wide] = events[k].time;
        }
        for (std::size_t k = 0; k < count; ++k) {
            Lanes<Real> const own = broadcast(copy[k].time);
            std::uint64_t before = 0, equal = 0;
            for (std::size_t row = 0; row < rows; ++row) {
                before |= std::uint64_t{bits_of_less(times[row], own)} << (row * wide);
                equal |= std::uint64_t{bits_of_equal(times[row], own)} << (row * wide);
            }
            before |= equal & ((std::uint64_t{1} << k) - 1);
            events[std::popcount(before)] = copy[k];
        }
    }

    static bool holds(NextEvents<Real> const& next, Event const& event) {
        return next[event.ball].time() == event.time;
    }

    static bool holds(NextEvents<Real> const& next, Ranked const& event) {
        return holds(next, static_cast<Event const&>(event)) && next.rank(event.ball) == event.rank;
    }

    /// Where events change again and again before they come, those that no longer hold must not
    /// fill the memory.
    void insert_in_heap(NextEvents<Real> const& next, std::int32_t ball) {
        if (heap_.size() >= std::max(2 * next.size(), row_max)) {
            std::erase_if(heap_, [&](Ranked const& event) { return !holds(next, event); });
            std::make_heap(heap_.begin(), heap_.end(), later_first);
        }
        heap_.push_back({{next[ball].time(), ball}, next.rank(ball)});
        std::push_heap(heap_.begin(), heap_.end(), later_first);
    }
    void make_heap_with(NextEvents<Real> const& next, std::int32_t ball) {
        for (std::size_t k = first_; k < end_; ++k)
            if (holds(next, row_[k])) insert_in_heap(next, row_[k].ball);
        clear_row();
        insert_in_heap(next, ball);
    }
    void drop_top() {
        std::pop_heap(heap_.begin(), heap_.end(), later_first);
        heap_.pop_back();
    }

    /// Of the events at the time of the first one.
    std::int32_t first_of_equals(NextEvents<Real> const& next) const {
        std::int32_t first = no_event;
        for (std::size_t k = first_; row_[k].time == row_[first_].time && k < end_; ++k) {
            if (holds(next, row_[k]) &&
                (first == no_event || next.precedes(row_[k].ball, first)))
                first = row_[k].ball;
        }
        return first;
    }

    std::vector<Event> row_; // from first_ to end_, where an event that never comes stands
    std::size_t first_ = 0, end_ = 0;
    std::vector<Ranked> heap_; // empty, or else no event is in the row
};

} // namespace clack
