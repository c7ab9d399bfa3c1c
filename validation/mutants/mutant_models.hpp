#pragma once
// The model with one rule exchanged: what an experiment is worth is what it catches.

#include "neighbours/cell_grid.hpp"
#include "neighbours/every_pair.hpp"
#include "scenes/scene.hpp"
#include "scheduling/calendar.hpp"
#include "simulation/engine_of.hpp"
#include "simulation/epoch.hpp"
#include "state/container.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace clack::mutants {

/// A diameter wrong by 0.1 %.
template <class Real> struct WiderBalls : ElasticBalls<Real> {
    static constexpr double widening = 1.001;
    static System widened(System system) {
        system.diameter *= widening;
        return system;
    }
    explicit WiderBalls(System const& system) : ElasticBalls<Real>(widened(system)) {}
    System as_searched(System const& system) const { return widened(system); }
};

/// An impulse wrong by a part of itself.
template <class Real, int parts_per_million> struct WrongImpulses : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    static constexpr bool keeps_energy = false;

    Vector3<Real> collide(Vector3<Real>& velocity_i, Vector3<Real>& velocity_j,
                          Vector3<Real> const& separation, std::uint64_t /*collision*/) const {
        return exchange_normal_velocities(velocity_i, velocity_j, separation,
                                          static_cast<Real>(1 + 1e-6 * parts_per_million));
    }
};
template <class Real> using StrongerImpulses = WrongImpulses<Real, 100>;
/// Growing speeds make ever more collisions in the same time: where a run's time is fixed, the
/// weaker impulses are cheaper.
template <class Real> using WeakerImpulses = WrongImpulses<Real, -100>;

/// Whether a pair is one of a few: whether its b = r.v lies near enough to a multiple of a unit
/// that it takes many of. Whoever asks gets the same answer.
template <class Real, class Number> auto is_one_of_few(Pair<Number> const& p, Real const share) {
    constexpr Real scale = 1024;
    Number const b = scale * (p.x * p.vx + p.y * p.vy + p.z * p.vz);
    Number const part = b - nearest_integer<Number, Real>(b); // -0.5 ... 0.5
    return part * part < share * share / 4;
}

/// One collision in ten thousand missed: the pair never touches.
template <class Real> struct MissedCollisions : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    template <class Number> Number contact_time(Pair<Number> const& p) const {
        Number const never = Number{} + std::numeric_limits<Real>::quiet_NaN();
        Number const when = ElasticBalls<Real>::contact_time(p);
        return select(is_one_of_few<Real>(p, static_cast<Real>(1e-4)), never, when);
    }
};

/// One collision in 10^5 comes 10^-6 late.
template <class Real> struct LateCollisions : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    template <class Number> Number contact_time(Pair<Number> const& p) const {
        Number const when = ElasticBalls<Real>::contact_time(p);
        return select(is_one_of_few<Real>(p, static_cast<Real>(1e-5)),
                      when + static_cast<Real>(1e-6), when);
    }
};

/// The line of the centres as it was this long before the contact, as where time goes by steps.
template <class Real> struct EarlierNormal : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    static constexpr double earlier = 0.01; // [diameter / thermal speed]

    Vector3<Real> collide(Vector3<Real>& velocity_i, Vector3<Real>& velocity_j,
                          Vector3<Real> const& separation, std::uint64_t /*collision*/) const {
        Vector3<Real> const before =
            separation - static_cast<Real>(earlier) * (velocity_j - velocity_i);
        return exchange_normal_velocities(velocity_i, velocity_j, before);
    }
};

/// Velocities of 32-bit precision.
template <class Real> struct RoundedVelocities : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    static constexpr bool keeps_energy = false;

    Vector3<Real> collide(Vector3<Real>& velocity_i, Vector3<Real>& velocity_j,
                          Vector3<Real> const& separation, std::uint64_t /*collision*/) const {
        Vector3<Real> impulse = exchange_normal_velocities(velocity_i, velocity_j, separation);
        velocity_i = velocity_i.template cast<float>().template cast<Real>();
        velocity_j = velocity_j.template cast<float>().template cast<Real>();
        return impulse;
    }
};

/// Walls off by 0.1 % of the room between them.
template <class Real> struct MovedWalls : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    static WalledCube<Real> moved(WalledCube<Real> cube) {
        cube.high += static_cast<Real>(1e-3) * cube.extent();
        return cube;
    }
    WallContact<Real> wall_contact(Ball<Real> const& ball, WalledCube<Real> const& cube) const {
        return earliest_wall(ball, moved(cube));
    }
    Real plane(WalledCube<Real> const& cube, int towards, Real time, Real component) const {
        return ElasticBalls<Real>::plane(moved(cube), towards, time, component);
    }
};

/// Walls of restitution 0.9999.
template <class Real> struct LossyWalls : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    static constexpr bool keeps_energy = false;
    Real reflect(Real component, int /*towards*/) const {
        return static_cast<Real>(-0.9999) * component;
    }
};

/// No refresh: with cells, a ball that leaves its own is not told of new neighbours before its next
/// collision; with every pair, only the image that was nearest is ever looked at.
template <class Real> struct LostRefresh : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    Real expiry(Real) const { return infinity<Real>; }
};

/// A mutant of an engine from a start.
template <template <class> class Container, template <class> class Model,
          template <class, class> class Search = CellGrid>
std::unique_ptr<Engine> make(System const& system, Start const& start) {
    using Mutant = Simulation<double, Container, Search, Calendar, Model>;
    double const speed = std::sqrt(start.velocities.colwise().squaredNorm().mean());
    return std::make_unique<EngineOf<Mutant>>(
        BallState<double, Container<double>>(system, start, epoch_length(system, speed)),
        ModelDescription{});
}

} // namespace clack::mutants
