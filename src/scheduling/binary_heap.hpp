#pragma once
// The textbook queue: a binary heap over the balls, each at a place that it knows, O(log n).

#include "scheduling/event_queue.hpp"

#include <utility>

namespace clack {

template <class Real> class BinaryHeap {
public:
    static constexpr Staleness staleness = Staleness::found;
    static constexpr Entries entries = Entries::one_a_ball;

    explicit BinaryHeap(std::size_t count) : heap_(count), place_(count) {}

    void rebuild(NextEvents<Real> const& next, Real) {
        for (std::size_t i = 0; i < heap_.size(); ++i) {
            heap_[i] = static_cast<std::int32_t>(i);
            place_[i] = i;
        }
        for (std::size_t i = heap_.size() / 2; i-- > 0;) sink(next, i);
    }

    void update(NextEvents<Real> const& next, std::int32_t ball) {
        std::size_t const place = place_[static_cast<std::size_t>(ball)];
        if (!rise(next, place)) sink(next, place);
    }

    std::int32_t earliest(NextEvents<Real> const& next) const {
        return next[heap_[0]].time() < infinity<Real> ? heap_[0] : no_event;
    }

    std::size_t bytes() const {
        return heap_.capacity() * sizeof(std::int32_t) + place_.capacity() * sizeof(std::size_t);
    }

private:
    bool rise(NextEvents<Real> const& next, std::size_t place) {
        std::size_t const start = place;
        while (place > 0) {
            std::size_t const parent = (place - 1) / 2;
            if (!next.precedes(heap_[place], heap_[parent])) break;
            exchange(place, parent);
            place = parent;
        }
        return place != start;
    }

    void sink(NextEvents<Real> const& next, std::size_t place) {
        for (;;) {
            std::size_t first = place;
            for (std::size_t child = 2 * place + 1; child <= 2 * place + 2; ++child) {
                if (child < heap_.size() && next.precedes(heap_[child], heap_[first]))
                    first = child;
            }
            if (first == place) return;
            exchange(place, first);
            place = first;
        }
    }

    void exchange(std::size_t a, std::size_t b) {
        std::swap(heap_[a], heap_[b]);
        place_[static_cast<std::size_t>(heap_[a])] = a;
        place_[static_cast<std::size_t>(heap_[b])] = b;
    }

    std::vector<std::int32_t> heap_;
    std::vector<std::size_t> place_;
};

} // namespace clack
