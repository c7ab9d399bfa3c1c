#pragma once
// Balls for tests: lattices with random velocities, random records, and nothing that a scene file
// would be needed for.

#include "simulation/engine.hpp"
#include "state/ball.hpp"
#include "state/snapshot.hpp"
#include "state/system.hpp"
#include "validation/lattice_start.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace clack::made_up {

using validation::uniform;

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

inline Start lattice(System const& system, std::uint64_t seed) {
    return validation::lattice_start(system, seed);
}

} // namespace clack::made_up
