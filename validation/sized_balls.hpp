#pragma once
// A diameter for each ball, through the engine's own templates: the record says how large a ball
// is, and a prediction asks both.

#include "prediction/earliest.hpp"
#include "resolution/elastic_balls.hpp"

#include <cstdint>
#include <limits>
#include <span>

namespace clack::validation {

/// What a ball's radius exceeds half the system's diameter by stands in its record's note. Two things stay behind that the seams do not carry, neither
/// of which takes time: the law that balls are in contact when they collide, which knows a pair but
/// not its balls; and the plane that stops a ball at a wall, which knows the wall alone.
template <class Real> struct DiameterOfEach : ElasticBalls<Real> {
    static constexpr bool keeps_notes = true;

    Real diameter, widest;

    explicit DiameterOfEach(System const& system)
        : ElasticBalls<Real>(system), diameter(static_cast<Real>(system.diameter)),
          widest(diameter) {}

    /// A search has to find the neighbours of the largest.
    System as_searched(System system) const {
        system.diameter = static_cast<double>(widest);
        return system;
    }

    Real diameter_squared(Pair<Real> const& pair, Real /*time*/) const {
        return pair.x * pair.x + pair.y * pair.y + pair.z * pair.z;
    }

    template <class Container>
    WallContact<Real> wall_contact(Ball<Real> const& ball, Container cube) const {
        if constexpr (Container::boundary == Boundary::walls) {
            cube.low += ball.note;
            cube.high -= ball.note;
        }
        return earliest_wall(ball, cube);
    }

    /// SteadyDiameter's, for pairs each with its own distance at contact. It has no number for
    /// "never" where its diameter is one a lane.
    ///   excess  of the two radii together, over the system's diameter
    template <class Number>
    [[gnu::always_inline]] Number contact_time(Pair<Number> const& p, Number const excess) const {
        Number const zero{}, never = zero + std::numeric_limits<Real>::quiet_NaN();
        Number const time = SteadyDiameter<Number>(excess + diameter).contact_time(p);
        return select(p.x * p.vx + p.y * p.vy + p.z * p.vz < zero, time, never);
    }
};

template <class Real, class Container>
using SizedScenery = Scenery<Real, Container, DiameterOfEach<Real>>;

// What follows takes the place of functions of the same names in prediction/earliest.hpp, which say
// why; the engine finds them by the model's namespace.

template <class Real, class Container>
[[gnu::always_inline]] inline Real contact_time(SizedScenery<Real, Container> const& scenery,
                                                std::int32_t i, std::int32_t j, Real now) {
    Ball<Real> const& one = scenery.balls[static_cast<std::size_t>(i)];
    Ball<Real> const& other = scenery.balls[static_cast<std::size_t>(j)];
    return scenery.model.contact_time(pair_of(one, other, scenery.cube, now),
                                      one.note + other.note);
}

template <Flight flight, class Real, class Container>
Contact<Real> earliest_in_lanes(SizedScenery<Real, Container> const& scenery, std::int32_t i,
                                std::span<std::int32_t const> candidates, Real now, Real limit) {
    using V = Lanes<Real>;
    using I = LaneIntegers<Real>;
    Ball<Real> const* const balls = scenery.balls.data();
    Ball<Real> const ball = balls[i];
    V best = broadcast(limit);
    I batch{}, tie{};
    for (std::size_t first = 0; first < candidates.size(); first += lane_count) {
        std::int32_t const* const chosen = candidates.data() + first;
        BallLanes<Real> const other = load_balls(balls, chosen);
        // The same loads and turns as for the velocities: made once.
        V const excess =
            turned<Real>([&](int k) { return velocity_four(balls[chosen[k]]); }).fourth;
        V const time = scenery.model.contact_time(pairs_of<flight>(ball, other, scenery.cube, now),
                                                  excess + ball.note);
        tie |= time == best;
        I const earlier = time < best;
        best = earlier ? time : best;
        batch = earlier ? I{} + static_cast<decltype(batch[0] + 0)>(first) : batch;
    }
    Real const time = folded(best, [](V const& a, V const& b) { return a < b ? a : b; });
    bool tied = bits_of(tie) != 0;
    if (!(time < limit) && !tied) return {};
    std::uint32_t const here = bits_of(best == time);
    tied |= (here & (here - 1)) != 0;
    if (tied) return earliest_one_by_one(scenery, i, candidates, now);
    auto const lane = static_cast<std::size_t>(__builtin_ctz(here));
    return {time, candidates[static_cast<std::size_t>(batch[lane]) + lane]};
}

/// For cubes in which a pair can touch through one image only.
template <class Real, class Container>
Contact<Real> earliest_contact(SizedScenery<Real, Container> const& scenery, std::int32_t i,
                               std::span<std::int32_t const> candidates, Real now,
                               [[maybe_unused]] Real limit = infinity<Real>) {
    if constexpr (has_lanes<Real>) {
        limit += std::numeric_limits<Real>::epsilon() * limit;
        if (scenery.balls[static_cast<std::size_t>(i)].time == now)
            return earliest_in_lanes<Flight::begins_now>(scenery, i, candidates, now, limit);
        return earliest_in_lanes<Flight::goes_on>(scenery, i, candidates, now, limit);
    }
    return earliest_one_by_one(scenery, i, candidates, now);
}

} // namespace clack::validation
