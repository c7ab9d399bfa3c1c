#pragma once
// More engines with one rule exchanged, for the laws of how balls meet and mix.

#include "scenes/scene.hpp"
#include "validation/mutants/mutant_models.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace clack::mutants {

/// Collisions missed beyond a part of the diameter's square: a pair whose paths would pass one
/// another farther out never touches, and nobody minds that it then overlaps.
template <class Real, int percent> struct MissedBeyond : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    static constexpr double grazing = percent / 100.0; // of b^2 over diameter^2

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

template <class Real> using MissedGrazing = MissedBeyond<Real, 99>;
template <class Real> using MissedHalf = MissedBeyond<Real, 50>;

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

/// A mutant of the cell engine from a scene's start.
template <template <class> class Container, template <class> class Model>
std::unique_ptr<Engine> make(Scene const& scene) {
    return make<Container, Model>(scene.system, make_start(scene));
}

} // namespace clack::mutants
