#pragma once
// Asks the memory in time for what the next events will read.

#include "scheduling/event_queue.hpp"
#include "state/ball_state.hpp"
#include "state/prefetch.hpp"

#include <cstdint>

namespace clack {

/// Each thing is asked for when that which leads to it has come: three events ahead the records of
/// the balls and their entries in the search, one event ahead what the search will then read.
/// Measured at 256 000 balls, packing fractions 0.05, 0.20 and 0.49: 1.15, 1.1 and 1.3 times as
/// fast.
struct LookAhead {
    template <class Search, class Queue>
    static constexpr bool possible = requires(Search search, Queue queue) {
        search.fetch(0);
        queue.upcoming(0);
    };

    template <class State, class Real, class Search, class Queue>
    static void look(State const& state, NextEvents<Real> const& next, Search const& search,
                     Queue const& queue) {
        for_balls_of(queue.upcoming(3), next, [&](std::int32_t ball) {
            prefetch(&state[ball]);
            search.fetch(ball);
        });
        std::int32_t const first = queue.upcoming(1);
        if (first == no_event) return;
        if (next.kind(first) == EventKind::expiry) {
            search.fetch_for_refresh(state.balls, first);
        } else {
            for_balls_of(first, next,
                         [&](std::int32_t ball) { search.fetch_candidates(state.balls, ball); });
        }
    }

private:
    template <class Real, class Task>
    static void for_balls_of(std::int32_t ball, NextEvents<Real> const& next, Task const& task) {
        if (ball == no_event) return;
        task(ball);
        if (next.kind(ball) == EventKind::ball) task(next[ball].partner);
    }
};

} // namespace clack
