#pragma once
// Asks the memory in time for what the next events will read.

#include "scheduling/next_events.hpp"
#include "state/ball_state.hpp"

#include <cstdint>

namespace clack {

/// Each thing is asked for when that which leads to it has come: two events ahead the records of
/// the two balls and their lists, one event ahead the records of those on the lists.
struct LookAhead {
    template <class Search, class Queue>
    static constexpr bool possible = requires(Search search, Queue queue) {
        search.fetch_for_refresh(0);
        queue.upcoming(0);
    };

    template <class State, class Real, class Search, class Queue>
    static void look(State const& state, NextEvents<Real> const& next, Search const& search,
                     Queue const& queue) {
        auto const fetch = [&](std::int32_t ball) {
            __builtin_prefetch(&state[ball]);
            search.fetch(ball);
        };
        if (std::int32_t const ball = queue.upcoming(2); ball != no_event) {
            fetch(ball);
            if (next[ball].partner >= 0) fetch(next[ball].partner);
        }
        std::int32_t const ball = queue.upcoming(1);
        if (ball == no_event) return;
        auto const fetch_listed = [&](std::int32_t centre) {
            for (std::int32_t const other : search.candidates(centre))
                __builtin_prefetch(&state[other]);
        };
        if (next.kind(ball) == EventKind::expiry) {
            search.fetch_for_refresh(ball);
        } else {
            fetch_listed(ball);
            if (next[ball].partner >= 0) fetch_listed(next[ball].partner);
        }
    }
};

} // namespace clack
