#pragma once
// The second of the two seams: which event is next.

#include "scheduling/next_events.hpp"

#include <concepts>

namespace clack {

/// Who learns that a ball has changed course.
enum class Staleness {
    swept, // the balls that were going to hit it, at once: the report's way, O(n)
    found  // nobody: an event whose two balls do not agree is found out when it comes up
};

/// Whether the queue hears of both balls of a collision or of one.
enum class Entries {
    one_a_ball,  // the next event of each has a place of its own
    one_an_event // an event of two balls stands in the queue once, for the ball that found it
};

constexpr std::int32_t no_event = -1;

template <class Queue, class Real>
concept EventQueue = requires(Queue queue, NextEvents<Real> const& next, std::int32_t ball,
                              Real now) {
    { Queue::staleness } -> std::convertible_to<Staleness>;
    { Queue::entries } -> std::convertible_to<Entries>;
    /// Starts afresh; `now` is the earliest time that will be asked for.
    queue.rebuild(next, now);
    /// The next event of a ball has changed.
    queue.update(next, ball);
    /// The ball whose event is first in the total order; no_event when none ever happens.
    { queue.earliest(next) } -> std::same_as<std::int32_t>;
    { queue.bytes() } -> std::same_as<std::size_t>;
};

} // namespace clack
