#pragma once
// Engines with one rule exchanged: what an experiment is worth is what it catches.

#include "neighbours/cell_grid.hpp"
#include "scenes/scene.hpp"
#include "scheduling/calendar.hpp"
#include "simulation/engine_of.hpp"
#include "simulation/epoch.hpp"
#include "state/container.hpp"

#include <algorithm>
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

/// An impulse wrong by 1e-4. Too weak rather than too strong: the balls slow down, whereas growing
/// speeds would make ever more collisions in the same time.
template <class Real> struct WeakerImpulses : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    static constexpr bool keeps_energy = false;

    Vector3<Real> collide(Vector3<Real>& velocity_i, Vector3<Real>& velocity_j,
                          Vector3<Real> const& separation, std::uint64_t /*collision*/) const {
        return exchange_normal_velocities(velocity_i, velocity_j, separation,
                                          static_cast<Real>(1 - 1e-4));
    }
};

/// One collision in ten thousand missed: a pair whose b = r.v lies that near to a multiple of its
/// unit never touches, whoever asks.
template <class Real> struct MissedCollisions : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    template <class Number> Number contact_time(Pair<Number> const& p) const {
        constexpr Real missed = static_cast<Real>(1e-4);
        constexpr Real scale = 1024; // so that b takes many units
        Number const b = scale * (p.x * p.vx + p.y * p.vy + p.z * p.vz);
        Number const part = b - nearest_integer<Number, Real>(b); // -0.5 ... 0.5
        Number const never = Number{} + std::numeric_limits<Real>::quiet_NaN();
        Number const when = ElasticBalls<Real>::contact_time(p);
        return select(part * part < missed * missed / 4, never, when);
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

/// No refresh: a ball that leaves its cell is not told of new neighbours before its next collision.
template <class Real> struct LostRefresh : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    Real expiry(Real) const { return infinity<Real>; }
};

/// Grazing collisions missed: a pair whose paths would pass within less than half a part in a
/// hundred of the diameter's edge never touches, and nobody minds that it then overlaps.
template <class Real> struct MissedGrazing : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    static constexpr double grazing = 0.99; // of b^2 over diameter^2

    template <class Number> Number contact_time(Pair<Number> const& p) const {
        Number const cx = p.y * p.vz - p.z * p.vy, cy = p.z * p.vx - p.x * p.vz,
                     cz = p.x * p.vy - p.y * p.vx;
        Number const limit =
            static_cast<Real>(grazing) * this->squared * (p.vx * p.vx + p.vy * p.vy + p.vz * p.vz);
        Number const never = Number{} + std::numeric_limits<Real>::quiet_NaN();
        Number const when = ElasticBalls<Real>::contact_time(p);
        return select(limit < cx * cx + cy * cy + cz * cz, never, when);
    }
    Real diameter_squared(Pair<Real> const& p, Real /*time*/) const {
        return std::min(this->squared, p.x * p.x + p.y * p.y + p.z * p.z);
    }
};

/// Balls that swap their whole velocities. Energy, momentum and every law of equilibrium hold, the
/// pressure included: only what happens on the way to it, and to single balls, is another.
template <class Real> struct SwappedVelocities : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;

    Vector3<Real> collide(Vector3<Real>& velocity_i, Vector3<Real>& velocity_j,
                          Vector3<Real> const& /*separation*/, std::uint64_t /*collision*/) const {
        std::swap(velocity_i, velocity_j);
        return velocity_j - velocity_i; // of j: what it has now less what it had
    }
};

/// A mutant of the cell engine from a start.
template <template <class> class Container, template <class> class Model>
std::unique_ptr<Engine> make(System const& system, Start const& start) {
    using Mutant = Simulation<double, Container, CellGrid, Calendar, Model>;
    double const speed = std::sqrt(start.velocities.colwise().squaredNorm().mean());
    return std::make_unique<EngineOf<Mutant>>(
        BallState<double, Container<double>>(system, start, epoch_length(system, speed)),
        ModelDescription{});
}

template <template <class> class Container, template <class> class Model>
std::unique_ptr<Engine> make(Scene const& scene) {
    return make<Container, Model>(scene.system, make_start(scene));
}

} // namespace clack::mutants
