#pragma once
// A constant field, through the engine's own templates. In the frame that was at rest when the
// epoch began and has fallen with the balls since, they fly straight and meet as they do without a
// field; what rises in it are the walls.

#include "resolution/elastic_balls.hpp"
#include "state/ball_state.hpp"

#include <cmath>

namespace clack::validation {

/// A cube whose walls rise: as fast along each axis, since the engine does not tell the model along
/// which one a wall reflects. The cells stay behind, which costs no correctness: the outermost have
/// no far side.
template <class Real> struct RisingCube : WalledCube<Real> {
    Real field;   // acceleration of a ball, downwards along each axis  [length / time^2]
    Real now = 0; // of the last flight to an event, which the model is not told either

    explicit RisingCube(System const& system, double strength = 0)
        : WalledCube<Real>(system), field(static_cast<Real>(strength)) {}

    Real risen(Real time) const { return field * time * time / 2; }
    Real pace(Real time) const { return field * time; }
};

/// Elastic balls between such walls.
template <class Real> struct FallingBalls : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    static constexpr bool keeps_energy = false; // the kinetic alone, which the law knows

    mutable RisingCube<Real> const* walls = nullptr; // the same all the time

    WallContact<Real> wall_contact(Ball<Real> const& ball, RisingCube<Real> const& cube) const {
        walls = &cube;
        WallContact<Real> best;
        Real const risen = cube.risen(ball.time), pace = cube.pace(ball.time);
        for (std::int32_t d = 0; d < 3; ++d) {
            Real const v = ball.velocity[d] - pace, place = ball.point[d] - risen;
            if (v == 0 && cube.field == 0) continue;
            Real const twice = 2 * cube.field, above = positive(place - cube.low);
            Real const gap = v > 0 ? positive(cube.high - place) : above;
            Real const speed = v > 0 ? v : -v;
            Real const root = square_root(v * v - (v > 0 ? twice : -twice) * gap);
            bool const turns = !(root == root); // before it is up
            Real const wait = turns ? (v + square_root(v * v + twice * above)) / cube.field
                                    : 2 * gap / (speed + root);
            Real const time = ball.time + wait;
            if (time < best.time) best = {time, 2 * d + (v > 0 && !turns ? 1 : 0)};
        }
        return best;
    }

    Real plane(RisingCube<Real> const& cube, int towards, Real time, Real /*component*/) const {
        return (towards < 0 ? cube.low : cube.high) + cube.risen(time);
    }

    Real reflect(Real component, int /*towards*/) const {
        return 2 * walls->pace(walls->now) - component;
    }

private:
    static Real positive(Real gap) { return gap > 0 ? gap : Real(0); }
};

} // namespace clack::validation

namespace clack {

/// Records in the frame of the epoch, which the next epoch leaves for one at rest.
template <class Real>
struct BallState<Real, validation::RisingCube<Real>> : BallState<Real, WalledCube<Real>> {
    using AtRest = BallState<Real, WalledCube<Real>>;
    validation::RisingCube<Real> cube;

    BallState(System const& of, Start const& start, double epoch_length, double field = 0)
        : AtRest(of, start, epoch_length), cube(of, field) {}

    void fly_to(std::int32_t ball, Real time) {
        AtRest::fly_to(ball, time);
        cube.now = time;
    }
    void set_records_to(Real offset) {
        AtRest::set_records_to(offset);
        Real const risen = cube.risen(offset), pace = cube.pace(offset);
        for (Ball<Real>& ball : this->balls) {
            for (int d = 0; d < 3; ++d) ball.point[d] -= risen;
            for (int d = 0; d < 3; ++d) ball.velocity[d] -= pace;
        }
    }
    Snapshot snapshot() const {
        Snapshot shot = AtRest::snapshot();
        shot.positions.array() -= static_cast<double>(cube.risen(this->clock.offset));
        shot.velocities.array() -= static_cast<double>(cube.pace(this->clock.offset));
        return shot;
    }
};

} // namespace clack
