#pragma once
// The first of the two seams: which balls can meet.

#include "state/ball.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace clack {

/// An index over the balls, built from their records at any moment and thrown away as lightly. Two
/// balls neither of which has expired are in each other's candidates, or cannot touch before one of
/// them expires. Spans stay valid until the next call and are padded with the ball itself to a
/// multiple of lane_count. A search may also give `candidates_of_both(i, j)`, two spans that are
/// valid together.
template <class Search, class Real>
concept NeighbourSearch = requires(Search search, std::vector<Ball<Real>> const& balls,
                                   std::int32_t ball, Real now) {
    /// Starts afresh from the records.
    search.rebuild(balls, now);
    /// A ball was written at the present moment and will be asked for its candidates: a chance to
    /// choose them anew.
    search.settle(balls, ball);
    /// Every ball that this one can touch before one of the two expires.
    { search.candidates(ball) } -> std::same_as<std::span<std::int32_t const>>;
    /// When the index no longer holds for a ball; asked after each change of its record.
    { search.expiry(balls, ball, now) } -> std::same_as<Real>;
    /// Brings the index up to date for a ball that expired; returns the candidates that it did
    /// not have before (and possibly others).
    { search.refresh(balls, ball, now) } -> std::same_as<std::span<std::int32_t const>>;
    { search.bytes() } -> std::same_as<std::size_t>;
};

} // namespace clack
