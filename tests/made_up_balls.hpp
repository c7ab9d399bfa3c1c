#pragma once
// Balls for tests: lattices with random velocities, random records, and nothing that a scene file
// would be needed for.

#include "simulation/engine.hpp"
#include "state/ball.hpp"
#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace clack::made_up {

/// Uniform in [low, high), the same on every machine.
inline double uniform(std::mt19937_64& random, double low = 0, double high = 1) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

template <class Real = double>
Vector3<Real> in_cube(std::mt19937_64& random, double low, double high) {
    Vector3<Real> place;
    for (int d = 0; d < 3; ++d) place[d] = static_cast<Real>(uniform(random, low, high));
    return place;
}

inline System system(Boundary boundary, std::int64_t count, double packing_fraction) {
    System made;
    made.boundary = boundary;
    made.count = count;
    made.side = std::cbrt(static_cast<double>(count) * std::numbers::pi / (6 * packing_fraction));
    return made;
}

/// Balls on the first sites of an fcc lattice that fills the container, with random velocities of
/// unit mean square and, in a periodic cube, no net momentum.
inline Start lattice(System const& system, std::uint64_t seed) {
    bool const periodic = system.boundary == Boundary::periodic;
    std::int64_t cells = 1;
    while (4 * cells * cells * cells < system.count) ++cells;
    double const edge = periodic ? system.side / static_cast<double>(cells)
                                 : system.accessible_side() / (static_cast<double>(cells) - 0.5);
    double const first = periodic ? 0 : system.diameter / 2;
    std::mt19937_64 random(seed);
    Start start;
    start.positions.resize(3, system.count);
    start.velocities.resize(3, system.count);
    for (std::int64_t k = 0; k < system.count; ++k) {
        std::int64_t const cell = k / 4, corner = k % 4;
        Eigen::Vector3d site(static_cast<double>(cell % cells),
                             static_cast<double>(cell / cells % cells),
                             static_cast<double>(cell / cells / cells));
        if (corner > 0) {
            site[0] += corner == 3 ? 0 : 0.5;
            site[1] += corner == 2 ? 0 : 0.5;
            site[2] += corner == 1 ? 0 : 0.5;
        }
        start.positions.col(k) = Eigen::Vector3d::Constant(first) + edge * site;
        start.velocities.col(k) = in_cube(random, -std::sqrt(3), std::sqrt(3));
    }
    if (periodic) {
        Eigen::Vector3d const mean = start.velocities.rowwise().mean();
        start.velocities.colwise() -= mean;
    }
    return start;
}

} // namespace clack::made_up
