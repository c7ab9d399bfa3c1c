#pragma once
// A start that needs no scene file and no mathematics library: the same on every machine and by
// every compiler.

#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <cmath>
#include <cstdint>
#include <random>

namespace clack::validation {

/// Uniform in [low, high) from the generator's bits alone.
inline double uniform(std::mt19937_64& random, double low = 0, double high = 1) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Balls on the first sites of an fcc lattice that fills the container, with random velocities of
/// unit mean square a component and, in a periodic cube, no net momentum.
inline Start lattice_start(System const& system, std::uint64_t seed) {
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
        std::int64_t const x = cell % cells, y = cell / cells % cells, z = cell / cells / cells;
        Eigen::Vector3d site(static_cast<double>(x), static_cast<double>(y),
                             static_cast<double>(z));
        for (int d = 0; d < 3; ++d) {
            if (corner > 0 && corner != 3 - d) site[d] += 0.5;
            start.velocities(d, k) = uniform(random, -1.75, 1.75);
        }
        start.positions.col(k) = Eigen::Vector3d::Constant(first) + edge * site;
    }
    if (periodic) {
        for (int d = 0; d < 3; ++d) {
            double sum = 0;
            for (std::int64_t k = 0; k < system.count; ++k) sum += start.velocities(d, k);
            start.velocities.row(d).array() -= sum / static_cast<double>(system.count);
        }
    }
    return start;
}

} // namespace clack::validation
