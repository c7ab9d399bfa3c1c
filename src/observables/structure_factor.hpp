#pragma once
// How strongly the density of the balls waves: S(k).

#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <Eigen/Core>

#include <vector>

namespace clack {

/// Eats snapshots of a periodic run: S(k) = <|sum over balls of exp(i k . r)|^2> / N for the waves
/// that fit into the cube, k = (2 pi / side) n with whole numbers n, averaged over those of one
/// length. The longest that fits is one side long.
class StructureFactor {
public:
    ///   largest_square  waves with |n|^2 up to this, at least 1
    /// Throws std::invalid_argument for fewer, or for a cube with walls.
    StructureFactor(System const& system, int largest_square);

    void add(Snapshot const& snapshot);

    /// The wave numbers |k|, rising. [1 / length]
    std::vector<double> wave_numbers() const;
    /// S at each; 0 before the first snapshot.
    std::vector<double> values() const;

private:
    struct Shell {
        int square;                         // |n|^2
        std::vector<Eigen::Vector3i> waves; // one of each n and -n
        double sum = 0;                     // of |...|^2 over waves and snapshots
    };

    System system_;
    std::vector<Shell> shells_;
    int longest_ = 0; // component of an n
    int snapshots_ = 0;
};

} // namespace clack
