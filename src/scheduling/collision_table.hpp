#pragma once
// The report's way: the table of next collisions itself, scanned for its minimum, O(n).

#include "scheduling/event_queue.hpp"

namespace clack {

template <class Real> class CollisionTable {
public:
    static constexpr Staleness staleness = Staleness::swept;
    static constexpr Entries entries = Entries::one_a_ball;

    explicit CollisionTable(std::size_t) {}

    void rebuild(NextEvents<Real> const&, Real) {}
    void update(NextEvents<Real> const&, std::int32_t) {}

    std::int32_t earliest(NextEvents<Real> const& next) const {
        auto const count = static_cast<std::int32_t>(next.size());
        std::int32_t first = 0;
        Real first_time = next[0].time();
        for (std::int32_t ball = 1; ball < count; ++ball) {
            Real const time = next[ball].time();
            if (time > first_time) continue;
            if (time < first_time || next.precedes(ball, first)) {
                first = ball;
                first_time = time;
            }
        }
        return first_time < infinity<Real> ? first : no_event;
    }

    std::size_t bytes() const { return 0; }
};

} // namespace clack
