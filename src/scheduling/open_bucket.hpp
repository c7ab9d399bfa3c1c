#pragma once
// The events of the bucket that is open, in order of time.

#include "prediction/lanes.hpp"
#include "scheduling/event_queue.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
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
    /// Where events are written one after the other.
    struct Room {
        Real* times;
        std::int32_t* balls;
    };

    OpenBucket() { clear(); }
    bool empty() const { return row_size() == 0 && heap_.empty(); }
    std::size_t size() const { return row_size() + heap_.size(); }
    /// The ball so many places behind the first, where that is known.
    std::int32_t upcoming(std::size_t places) const {
        return row_size() <= places ? no_event : balls_[first_ + places];
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
        for (; place > first_ && time < times_[place - 1]; --place) {
            times_[place] = times_[place - 1];
            balls_[place] = balls_[place - 1];
        }
        times_[place] = time;
        balls_[place] = ball;
        times_[end_] = infinity<Real>;
    }

    /// Events of a bucket that is being opened, none of which comes before one that is here: where
    /// to write them, `written` being there already. `append` then takes the first `count`.
    Room room(std::size_t written, std::size_t more) {
        make_room(more, written);
        return {times_.data() + end_, balls_.data() + end_};
    }
    void append(NextEvents<Real> const& next, std::size_t count) {
        if (row_size() + count > row_max || !heap_.empty()) {
            auto const begin = balls_.begin() + static_cast<std::ptrdiff_t>(end_);
            std::vector<std::int32_t> const many(begin, begin + static_cast<std::ptrdiff_t>(count));
            times_[end_] = infinity<Real>;
            for (std::int32_t const ball : many) insert(next, ball);
            return;
        }
        put_in_order(times_.data() + end_, balls_.data() + end_, count);
        end_ += count;
        times_[end_] = infinity<Real>;
    }

    /// The ball whose event is first in the total order; no_event when none holds any more.
    std::int32_t earliest(NextEvents<Real> const& next) {
        for (; times_[first_] < infinity<Real>; ++first_) {
            if (times_[first_ + 1] == times_[first_]) {
                std::int32_t const ball = first_of_equals(next);
                if (ball != no_event) return ball;
            } else if (holds(next, first_)) {
                return balls_[first_];
            }
        }
        return heap_.empty() ? no_event : earliest_in_heap(next);
    }

    std::size_t bytes() const {
        return times_.capacity() * sizeof(Real) + balls_.capacity() * sizeof(std::int32_t) +
               heap_.capacity() * sizeof(Ranked);
    }

private:
    static constexpr std::size_t row_max = 64;

    struct Ranked {
        Real time;
        std::int32_t ball;
        typename NextEvents<Real>::Rank rank;
    };
    static bool later_first(Ranked const& a, Ranked const& b) {
        return a.time != b.time ? a.time > b.time : a.rank > b.rank;
    }

    std::size_t row_size() const { return end_ - first_; }
    void clear_row() {
        first_ = end_ = 0;
        if (times_.empty()) resize(4 * row_max);
        times_[0] = infinity<Real>;
    }
    std::size_t room_size() const { return balls_.size() - lane_count; }
    void resize(std::size_t size) {
        balls_.resize(size + lane_count); // and padding of the last lanes
        times_.resize(size + lane_count);
    }

    /// Behind the row and what is written there, and for the event at infinity that ends it.
    void make_room(std::size_t more, std::size_t written = 0) {
        if (end_ + written + more < room_size()) return;
        std::size_t const kept = row_size() + std::max<std::size_t>(written, 1);
        std::copy_n(times_.data() + first_, kept, times_.data());
        std::copy_n(balls_.data() + first_, kept, balls_.data());
        end_ -= first_;
        first_ = 0;
        if (end_ + written + more >= room_size()) resize(2 * (end_ + written + more + 1));
    }

    /// Each goes behind those that are earlier, and of equal ones behind those that were before it.
    /// How many are earlier is counted many at a time, without a branch: the steps of a sort cannot
    /// be foretold. What follows the times may be overwritten.
    static void put_in_order(Real* times, std::int32_t* balls, std::size_t count) {
        constexpr std::size_t wide = lane_count;
        std::array<Real, row_max> unsorted;
        std::array<std::int32_t, row_max> their_balls;
        std::fill_n(times + count, wide, infinity<Real>);
        auto const copy_from = [&](std::size_t first) { // of constant size
            if constexpr (has_lanes<Real>) {
                copy_lanes(times + first, unsorted.data() + first);
            } else {
                std::copy_n(times + first, wide, unsorted.data() + first);
            }
            copy_lanes(balls + first, their_balls.data() + first);
        };
        copy_from(0); // most often all there is; a loop alone would become a call
        for (std::size_t first = wide; first < count; first += wide) copy_from(first);
        for (std::size_t k = 0; k < count; ++k) {
            std::size_t const rank = rank_of(k, unsorted.data(), count);
            times[rank] = unsorted[k];
            balls[rank] = their_balls[k];
        }
    }
    static std::size_t rank_of(std::size_t k, Real const* times, std::size_t count) {
        if constexpr (has_lanes<Real>) {
            Lanes<Real> const own = broadcast(times[k]);
            std::uint64_t before = 0, equal = 0;
            for (std::size_t first = 0; first < count; first += lane_count) {
                Lanes<Real> some;
                std::memcpy(&some, times + first, sizeof some);
                before |= std::uint64_t{bits_of_less(some, own)} << first;
                equal |= std::uint64_t{bits_of_equal(some, own)} << first;
            }
            before |= equal & ((std::uint64_t{1} << k) - 1);
            return static_cast<std::size_t>(std::popcount(before));
        } else {
            std::size_t before = 0;
            for (std::size_t other = 0; other < count; ++other)
                before += times[other] < times[k] || (times[other] == times[k] && other < k);
            return before;
        }
    }

    bool holds(NextEvents<Real> const& next, std::size_t place) const {
        return next[balls_[place]].time() == times_[place];
    }
    static bool holds(NextEvents<Real> const& next, Ranked const& event) {
        return next[event.ball].time() == event.time && next.rank(event.ball) == event.rank;
    }

    /// Where events change again and again before they come, those that no longer hold must not
    /// fill the memory.
    [[gnu::noinline]] void insert_in_heap(NextEvents<Real> const& next, std::int32_t ball) {
        if (heap_.size() >= std::max(2 * next.size(), row_max)) {
            std::erase_if(heap_, [&](Ranked const& event) { return !holds(next, event); });
            std::make_heap(heap_.begin(), heap_.end(), later_first);
        }
        heap_.push_back({next[ball].time(), ball, next.rank(ball)});
        std::push_heap(heap_.begin(), heap_.end(), later_first);
    }
    [[gnu::noinline]] void make_heap_with(NextEvents<Real> const& next, std::int32_t ball) {
        for (std::size_t place = first_; place < end_; ++place)
            if (holds(next, place)) insert_in_heap(next, balls_[place]);
        clear_row();
        insert_in_heap(next, ball);
    }
    [[gnu::noinline]] std::int32_t earliest_in_heap(NextEvents<Real> const& next) {
        for (; !heap_.empty(); drop_top()) {
            Ranked const& top = heap_.front();
            if (holds(next, top)) return top.ball;
        }
        return no_event;
    }
    void drop_top() {
        std::pop_heap(heap_.begin(), heap_.end(), later_first);
        heap_.pop_back();
    }

    /// Of the events at the time of the first one.
    [[gnu::noinline]] std::int32_t first_of_equals(NextEvents<Real> const& next) const {
        std::int32_t first = no_event;
        for (std::size_t k = first_; times_[k] == times_[first_] && k < end_; ++k) {
            if (holds(next, k) && (first == no_event || next.precedes(balls_[k], first)))
                first = balls_[k];
        }
        return first;
    }

    // The row, from first_ to end_, where a time that never comes stands.
    std::vector<Real> times_;
    std::vector<std::int32_t> balls_;
    std::size_t first_ = 0, end_ = 0;
    std::vector<Ranked> heap_; // empty, or else no event is in the row
};

} // namespace clack
