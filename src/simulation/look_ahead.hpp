#pragma once
// Asks the memory in time for what the next events will read.

#include "scheduling/event_queue.hpp"
#include "state/ball_state.hpp"
#include "state/prefetch.hpp"

#include <algorithm>
#include <cstdint>

namespace clack {

/// Each thing is asked for when that which leads to it has come: six events ahead the records of
/// the balls, their entries in the search and what whom they meet has planned, four ahead what the
/// search will then read, and, among many balls, what those in its lists have planned and, one
/// ahead, the records of what it will find.
/// Measured at 256 000 balls, packing fractions 0.05, 0.20 and 0.49: 1.15, 1.1 and 1.3 times as
/// fast; with the partners' plans 1.07, 1.04 and 1.1 on top, with the cells of the place and the
/// time to come 1.08 and 1.04, with the records of what is found 1.45 and 1.3. These bring 1.3 and
/// 1.07 among 64 000 balls, and cost more than they bring among 32 000 (0.85), where they are in a
/// cache of some kind already. With lists the plans bring 1.06 to 1.2 among 256 000, what a new
/// list is made of 1.03 to 1.05; among 32 000 the two cost 1.03. The plans of what cells find bring
/// nothing.
struct LookAhead {
    template <class Search, class Queue>
    static constexpr bool possible = requires(Search search, Queue queue) {
        search.fetch(0);
        queue.upcoming(0);
    };

    template <class State, class Real, class Search, class Queue>
    static void look(State const& state, NextEvents<Real> const& next, Search& search,
                     Queue const& queue) {
        std::int32_t const sixth = queue.upcoming(6);
        for_balls_of(sixth, next, [&](std::int32_t ball, Real) {
            prefetch(&state[ball]);
            search.fetch(ball);
        });
        if (sixth != no_event) prefetch(&next[std::max(next[sixth].partner, 0)]);
        for_tasks_of(
            queue.upcoming(4), next,
            [&](std::int32_t ball, Real time) {
                search.fetch_candidates(state.balls, ball, time);
                if (among_many(state)) fetch_plans(next, search, ball);
            },
            [&](std::int32_t ball) { search.fetch_for_refresh(state.balls, ball); });
        if constexpr (requires { search.fetch_fresh_records(state.balls, 0); }) {
            if (among_many(state)) fetch_records(state.balls, next, search, queue.upcoming(1));
        }
    }

private:
    template <class State> static bool among_many(State const& state) {
        return state.count() >= 48'000; // measured as above
    }

    /// Calls task(ball, time) for a ball and, where it collides, for the other one.
    template <class Real, class Task>
    static void for_balls_of(std::int32_t ball, NextEvents<Real> const& next, Task const& task) {
        if (ball == no_event) return;
        Real const time = next[ball].time();
        task(ball, time);
        if (next.kind(ball) == EventKind::ball) task(next[ball].partner, time);
    }

    /// What the event of a ball asks for: all candidates of one or two balls, or fresh ones.
    template <class Real, class All, class Fresh>
    static void for_tasks_of(std::int32_t ball, NextEvents<Real> const& next, All const& all,
                             Fresh const& fresh) {
        if (ball == no_event) return;
        next.kind(ball) == EventKind::expiry ? fresh(ball) : for_balls_of(ball, next, all);
    }

    /// Of the balls in a list, which are known before they are searched.
    template <class Real, class Search>
    static void fetch_plans(NextEvents<Real> const& next, Search const& search, std::int32_t ball) {
        auto const fetch = [&](std::int32_t other) { prefetch(&next[other]); };
        if constexpr (requires { search.for_each_in_first_line(ball, fetch); })
            search.for_each_in_first_line(ball, fetch);
    }

    template <class Balls, class Real, class Search>
    static void fetch_records(Balls const& balls, NextEvents<Real> const& next, Search& search,
                              std::int32_t ball) {
        if (ball == no_event) return;
        NextEvent<Real> const& event = next[ball];
        EventKind const kind = next.kind(ball);
        if (kind == EventKind::expiry) return search.fetch_fresh_records(balls, ball);
        if constexpr (requires { search.fetch_records(balls, ball, event.time()); }) {
            kind == EventKind::ball ? search.fetch_records(balls, ball, event.partner, event.time())
                                    : search.fetch_records(balls, ball, event.time());
        }
    }
};

} // namespace clack
