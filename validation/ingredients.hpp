#pragma once
// What a scene may ask for beyond equal elastic balls, each as the smallest policy that shows where
// it goes. All of them are neutral here, so that the balls move as they do without: a mass of 1, a
// restitution of 1. Diameters are in sized_balls.hpp, a field in constant_field.hpp.

#include "resolution/elastic_balls.hpp"
#include "resolution/growing_balls.hpp"
#include "state/container.hpp"

#include <cstddef>
#include <cstring>

namespace clack::validation {

/// Periodic code between walls: each separation goes to the nearest image, in a cube so wide that
/// it is there already.
template <class Real> struct WrappedPairs : ElasticBalls<Real> {
    PeriodicCube<Real> cube;

    explicit WrappedPairs(System const& system)
        : ElasticBalls<Real>(system), cube(twice_as_wide(system)) {}

    static System twice_as_wide(System system) {
        system.side *= 2;
        return system;
    }

    template <class Number> [[gnu::always_inline]] Number contact_time(Pair<Number> p) const {
        p.x = p.x - cube.image(p.x) * cube.side;
        p.y = p.y - cube.image(p.y) * cube.side;
        p.z = p.z - cube.image(p.z) * cube.side;
        return ElasticBalls<Real>::contact_time(p);
    }
};

/// A mass for each ball: what it is heavier than 1 stands in its record's note, behind its
/// velocity.
template <class Real> struct MassOfEach : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    static constexpr bool keeps_notes = true;
    static constexpr bool keeps_energy = false; // that of equal masses, which the law knows

    static Real mass_of(Vector3<Real> const& velocity) {
        static_assert(offsetof(Ball<Real>, note) ==
                      offsetof(Ball<Real>, velocity) + 3 * sizeof(Real));
        Real excess;
        std::memcpy(&excess, reinterpret_cast<char const*>(&velocity) + 3 * sizeof(Real),
                    sizeof excess);
        return 1 + excess;
    }

    /// As equal balls do (resolution/bounce.hpp), each with its share of twice the reduced mass.
    Vector3<Real> collide(Vector3<Real>& velocity_i, Vector3<Real>& velocity_j,
                          Vector3<Real> const& separation, std::uint64_t /*collision*/) const {
        Real const approach = dot<Real>(separation, velocity_j - velocity_i);
        if (!(approach < 0)) return Vector3<Real>::Zero();
        Real const mass_i = mass_of(velocity_i), mass_j = mass_of(velocity_j);
        Real const twice_inverse = 2 / (mass_i + mass_j);
        Real const share_i = mass_j * twice_inverse, share_j = mass_i * twice_inverse;
        Real const distance2 = dot<Real>(separation, separation);
        Real const ratio = approach / distance2;
        Real const rest =
            (fused(-ratio, distance2, approach) - ratio * square_rest(separation)) / distance2;
        Vector3<Real> kick;
        for (int d = 0; d < 3; ++d) kick[d] = fused(separation[d], ratio, separation[d] * rest);
        velocity_i += share_i * kick;
        velocity_j -= share_j * kick;
        if (dot<Real>(separation, velocity_j - velocity_i) < 0)
            std::tie(velocity_i, velocity_j) =
                turn_apart<Real>(velocity_i, velocity_j, separation, distance2);
        return -(mass_j * share_j) * kick;
    }
};

/// Collisions that may lose energy. The normal relative velocity comes back `restitution` times.
template <class Real> struct Restitution : ElasticBalls<Real> {
    static constexpr bool keeps_energy = false;
    Real share;

    explicit Restitution(System const& system, double restitution = 1)
        : ElasticBalls<Real>(system), share(static_cast<Real>((1 + restitution) / 2)) {}

    Vector3<Real> collide(Vector3<Real>& velocity_i, Vector3<Real>& velocity_j,
                          Vector3<Real> const& separation, std::uint64_t /*collision*/) const {
        return exchange_normal_velocities(velocity_i, velocity_j, separation, share);
    }
};

/// Growing balls that do not grow.
template <class Real> struct UngrownBalls : GrowingBalls<Real> {
    explicit UngrownBalls(System const& system)
        : GrowingBalls<Real>{static_cast<Real>(system.diameter), 0,
                             static_cast<Real>(system.diameter)} {}
};

} // namespace clack::validation
