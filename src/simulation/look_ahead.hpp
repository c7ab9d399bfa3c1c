#pragma once
// Asks the memory in time for what the next events will read.

#include "prediction/screen.hpp"
#include "scheduling/next_events.hpp"
#include "state/ball_state.hpp"

#include <cstdint>

namespace clack {

/// Each thing is asked for when that which leads to it has come. Measured where the balls outgrow
/// the cache: lists gain a tenth or two by it. With cells the next readers are too many, and it
/// costs a tenth: they offer nothing to fetch.
class LookAhead {
public:
    static constexpr std::int32_t outgrows_cache = 32'768; // balls

    template <class Search, class Queue>
    static constexpr bool possible = requires(Search search, Queue queue) {
        search.fetch_for_refresh(0);
        queue.position();
    };

    void restart() { looked_ = 0; }

    /// After the queue has gone on to another bucket.
    template <class State, class Search, class Queue, class Real, class Container>
    void look(State const& state, NextEvents<Real> const& next, Search const& search,
              Queue const& queue, Screen<Container> const& screen) {
        std::int64_t const position = queue.position();
        if (position - looked_ > 2 * stage) looked_ = position - 1; // a gap holds nothing
        for (; looked_ < position; ++looked_) {
            queue.fetch(looked_ + 4 * stage);
            queue.foresee(looked_ + 3 * stage, [&](std::int32_t ball) {
                __builtin_prefetch(&next[ball]);
                __builtin_prefetch(&state[ball]);
                search.fetch(ball);
            });
            queue.foresee(looked_ + 2 * stage, [&](std::int32_t ball) {
                bool const waits = queue.waits_in(looked_ + 2 * stage, next[ball]);
                if (waits && next.kind(ball) == EventKind::expiry) search.fetch_for_refresh(ball);
            });
            queue.foresee(looked_ + stage, [&](std::int32_t ball) {
                if (!queue.waits_in(looked_ + stage, next[ball])) return;
                screen.fetch(ball);
                for (std::int32_t const other : search.candidates(ball)) screen.fetch(other);
            });
        }
    }

private:
    static constexpr std::int64_t stage = 2; // buckets: measured flat from one to three
    std::int64_t looked_ = 0;                // the bucket from which was last looked ahead
};

} // namespace clack
