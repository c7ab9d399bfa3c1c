#pragma once
// Engines with one rule exchanged: what an experiment is worth is what it catches.

#include "neighbours/cell_grid.hpp"
#include "scenes/scene.hpp"
#include "scheduling/calendar.hpp"
#include "simulation/engine_of.hpp"
#include "simulation/epoch.hpp"
#include "state/container.hpp"

#include <cmath>
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

/// No refresh: a ball that leaves its cell is not told of new neighbours before its next collision.
template <class Real> struct LostRefresh : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    Real expiry(Real) const { return infinity<Real>; }
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
