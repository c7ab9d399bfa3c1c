#pragma once
// A queue of constant cost: a ring of time buckets, and a small heap for the one that is open.
// G. Paul, J. Comput. Phys. 221, 615 (2007); B. D. Lubachevsky, J. Comput. Phys. 94, 255 (1991).

#include "scheduling/event_queue.hpp"

#include <algorithm>
#include <cmath>

namespace clack {

/// Each ball waits in the bucket of its next event's time, in a doubly linked list threaded through
/// arrays, so nothing is allocated. The buckets cover one revolution; what lies beyond waits in one
/// more list that is dealt out when the ring comes round. When a bucket is opened its balls go into
/// a heap, whose entries are dropped when they surface and no longer hold.
template <class Real> class Calendar {
public:
    static constexpr Staleness staleness = Staleness::found;

    explicit Calendar(std::size_t count)
        : next_(count), previous_(count), bucket_(count, unlisted) {
        std::size_t buckets = 4;
        while (buckets < count) buckets *= 2;
        head_.assign(buckets + 1, none);
    }

    void rebuild(NextEvents<Real> const& next, Real now) {
        std::fill(head_.begin(), head_.end(), none);
        std::fill(bucket_.begin(), bucket_.end(), unlisted);
        heap_.clear();
        base_ = now;
        inverse_width_ = 1 / bucket_width(next, now);
        open_ = 0;
        revolution_ = 0;
        for (std::int32_t ball = 0; ball < static_cast<std::int32_t>(next.size()); ++ball)
            file(next, ball);
    }

    void update(NextEvents<Real> const& next, std::int32_t ball) {
        auto const bucket = bucket_[static_cast<std::size_t>(ball)];
        if (bucket != unlisted) {
            if (list_of(next[ball].time()) == bucket) return;
            unlink(ball);
        }
        file(next, ball);
    }

    std::int32_t earliest(NextEvents<Real> const& next) {
        for (;;) {
            while (!heap_.empty()) {
                std::int32_t const first = first_at_top(next, 0, no_event);
                if (first != no_event) return first;
                pop();
            }
            if (!open_next_bucket(next)) return no_event;
        }
    }

    std::size_t bytes() const {
        return (next_.capacity() + previous_.capacity() + bucket_.capacity() + head_.capacity()) *
                   sizeof(std::int32_t) +
               heap_.capacity() * sizeof(Entry);
    }

private:
    static constexpr std::int32_t none = -1;
    static constexpr std::int32_t unlisted = -1;

    struct Entry {
        Real time;
        std::int32_t ball;
    };
    static bool after(Entry const& a, Entry const& b) { return a.time > b.time; }

    std::int64_t ring() const { return static_cast<std::int64_t>(head_.size()) - 1; }

    /// Four balls a bucket if all waited equally long: measured flat between two and eight.
    Real bucket_width(NextEvents<Real> const& next, Real now) const {
        Real sum = 0;
        Real waiting = 0;
        for (std::int32_t ball = 0; ball < static_cast<std::int32_t>(next.size()); ++ball) {
            Real const time = next[ball].time();
            if (!(time < infinity<Real>)) continue;
            sum += time - now;
            waiting += 1;
        }
        constexpr int balls_per_bucket = 4;
        Real const width = balls_per_bucket * sum / (waiting * waiting);
        return width > 0 && width < infinity<Real> ? width : Real(1);
    }

    /// Buckets since `base_`; rounding in the product is monotonic, so order between buckets holds.
    std::int64_t bucket_at(Real time) const {
        Real const index = (time - base_) * inverse_width_;
        Real const far = static_cast<Real>(0x1p62);
        return index < far ? static_cast<std::int64_t>(index) : static_cast<std::int64_t>(0x1p62);
    }

    /// The list that a time belongs to: a bucket of the present revolution, or the one beyond.
    std::int32_t list_of(Real time) const {
        if (!(time < infinity<Real>)) return unlisted;
        std::int64_t const bucket = bucket_at(time);
        if (bucket <= open_) return unlisted;
        return static_cast<std::int32_t>(std::min(bucket - revolution_, ring()));
    }

    void file(NextEvents<Real> const& next, std::int32_t ball) {
        Real const time = next[ball].time();
        std::int32_t const list = list_of(time);
        if (list != unlisted) {
            link(ball, list);
        } else if (time < infinity<Real>) {
            heap_.push_back({time, ball});
            std::push_heap(heap_.begin(), heap_.end(), after);
        }
    }

    void link(std::int32_t ball, std::int32_t list) {
        auto const b = static_cast<std::size_t>(ball);
        std::int32_t& head = head_[static_cast<std::size_t>(list)];
        bucket_[b] = list;
        previous_[b] = none;
        next_[b] = head;
        if (head != none) previous_[static_cast<std::size_t>(head)] = ball;
        head = ball;
    }

    void unlink(std::int32_t ball) {
        auto const b = static_cast<std::size_t>(ball);
        if (previous_[b] == none) {
            head_[static_cast<std::size_t>(bucket_[b])] = next_[b];
        } else {
            next_[static_cast<std::size_t>(previous_[b])] = next_[b];
        }
        if (next_[b] != none) previous_[static_cast<std::size_t>(next_[b])] = previous_[b];
        bucket_[b] = unlisted;
    }

    void pop() {
        std::pop_heap(heap_.begin(), heap_.end(), after);
        heap_.pop_back();
    }

    bool open_next_bucket(NextEvents<Real> const& next) {
        for (;;) {
            while (++open_ < revolution_ + ring()) {
                if (head_[static_cast<std::size_t>(open_ - revolution_)] != none) {
                    empty_into_heap(next, open_ - revolution_);
                    return true;
                }
            }
            if (!turn(next)) return false;
            if (!heap_.empty()) return true;
        }
    }

    void empty_into_heap(NextEvents<Real> const& next, std::int64_t list) {
        for (std::int32_t ball = head_[static_cast<std::size_t>(list)]; ball != none;
             ball = next_[static_cast<std::size_t>(ball)]) {
            heap_.push_back({next[ball].time(), ball});
            bucket_[static_cast<std::size_t>(ball)] = unlisted;
        }
        head_[static_cast<std::size_t>(list)] = none;
        std::make_heap(heap_.begin(), heap_.end(), after);
    }

    /// The ring is empty: the revolution moves on to the first event of those beyond it, whose
    /// bucket becomes the open one, and the rest are dealt out.
    bool turn(NextEvents<Real> const& next) {
        std::int32_t& beyond = head_.back();
        if (beyond == none) {
            open_ = revolution_ + ring() - 1; // stays closed until an update brings something
            return false;
        }
        std::int64_t first = std::numeric_limits<std::int64_t>::max();
        for (std::int32_t ball = beyond; ball != none; ball = next_[static_cast<std::size_t>(ball)])
            first = std::min(first, bucket_at(next[ball].time()));
        open_ = revolution_ = first;
        std::int32_t ball = std::exchange(beyond, none);
        while (ball != none) {
            std::int32_t const following = next_[static_cast<std::size_t>(ball)];
            bucket_[static_cast<std::size_t>(ball)] = unlisted;
            file(next, ball);
            ball = following;
        }
        return true;
    }

    /// The heap goes by time alone. Entries as early as its top hang together below it; of those
    /// that still hold, the first in the total order.
    std::int32_t first_at_top(NextEvents<Real> const& next, std::size_t entry,
                              std::int32_t first) const {
        if (entry >= heap_.size() || heap_[entry].time != heap_[0].time) return first;
        std::int32_t const ball = heap_[entry].ball;
        if (next[ball].time() == heap_[entry].time &&
            (first == no_event || next.precedes(ball, first)))
            first = ball;
        first = first_at_top(next, 2 * entry + 1, first);
        return first_at_top(next, 2 * entry + 2, first);
    }

    std::vector<std::int32_t> next_, previous_; // in a ball's list
    std::vector<std::int32_t> bucket_;          // the list that a ball is in
    std::vector<std::int32_t> head_;            // of the ring's lists, and of the one beyond
    std::vector<Entry> heap_;                   // the open bucket
    Real base_ = 0, inverse_width_ = 1;
    std::int64_t open_ = 0, revolution_ = 0; // the open bucket, the first of the revolution
};

} // namespace clack
