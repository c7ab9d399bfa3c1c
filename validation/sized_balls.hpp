#pragma once
// A diameter for each ball, through the engine's own templates: the record says how large a ball
// is, and a prediction asks both.

#include "prediction/earliest.hpp"
#include "resolution/elastic_balls.hpp"

#include <cstdint>
#include <limits>
#include <span>

namespace clack::validation {

/// A pair, or one a lane, and what the two radii together exceed the system's diameter by.
template <class Number> struct SizedPair : Pair<Number> { Number excess; };

/// What a ball's radius exceeds half the system's diameter by stands in its record's note. Two
/// things stay behind that the seams do not carry, neither of which takes time: the law that balls
/// are in contact when they collide, which knows a pair but not its balls; and the plane that stops
/// a ball at a wall, which knows the wall alone.
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
    template <class Number>
    [[gnu::always_inline]] Number contact_time(SizedPair<Number> const& p) const {
        Number const zero{}, never = zero + std::numeric_limits<Real>::quiet_NaN();
        Number const time = SteadyDiameter<Number>(p.excess + diameter).contact_time(p);
        return select(p.x * p.vx + p.y * p.vy + p.z * p.vz < zero, time, never);
    }
};

template <class Real, class Container>
using SizedScenery = Scenery<Real, Container, DiameterOfEach<Real>>;

/// A cube by which the engine's loop over candidates finds the pairs below.
template <class Container> struct CubeOfSizes : Container {};

// What follows takes the place of functions of the same names in prediction/earliest.hpp, which say
// why; the engine finds them by the namespace of the model, or of the cube.

template <class Real, class Container>
[[gnu::always_inline]] inline Real contact_time(SizedScenery<Real, Container> const& scenery,
                                                std::int32_t i, std::int32_t j, Real now) {
    Ball<Real> const& one = scenery.balls[static_cast<std::size_t>(i)];
    Ball<Real> const& other = scenery.balls[static_cast<std::size_t>(j)];
    return scenery.model.contact_time(
        SizedPair<Real>{pair_of(one, other, scenery.cube, now), one.note + other.note});
}

template <Flight flight, class Real, class Container>
[[gnu::always_inline]] inline SizedPair<Lanes<Real>>
pairs_of(Ball<Real> const& ball, BallLanes<Real> const& other, CubeOfSizes<Container> const& cube,
         Real now) {
    Container const& plain = cube;
    return {pairs_of<flight>(ball, other, plain, now), other.note + ball.note};
}

/// The scene as the engine's loop over candidates is to see it; for cubes in which a pair can touch
/// through one image only.
template <class Real, class Container> struct SizesSeen {
    CubeOfSizes<Container> cube;
    SizedScenery<Real, CubeOfSizes<Container>> scenery;

    explicit SizesSeen(SizedScenery<Real, Container> const& plain)
        : cube{plain.cube}, scenery{plain.balls, plain.numbers, cube, plain.model, false} {}
};

template <class Real, class Container>
Contact<Real> earliest_contact(SizedScenery<Real, Container> const& scenery, std::int32_t i,
                               std::span<std::int32_t const> candidates, Real now,
                               Real limit = infinity<Real>) {
    SizesSeen<Real, Container> const seen(scenery);
    return clack::earliest_contact(seen.scenery, i, candidates, now, limit);
}
template <class Real, class Container>
std::pair<Contact<Real>, Contact<Real>>
earliest_contacts(SizedScenery<Real, Container> const& scenery, std::int32_t i,
                  std::span<std::int32_t const> candidates_i, std::int32_t j,
                  std::span<std::int32_t const> candidates_j, Real now) {
    SizesSeen<Real, Container> const seen(scenery);
    return clack::earliest_contacts(seen.scenery, i, candidates_i, j, candidates_j, now);
}

} // namespace clack::validation
