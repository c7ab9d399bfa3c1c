#pragma once
// How many balls there are around a ball at a distance: g(r).

#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <cstdint>
#include <vector>

namespace clack {

/// Eats snapshots of a periodic run.
/// g(r) is the density of pairs over that of the mean density, N rho / 2 per volume: 1 - 1/N for
/// balls that do not see each other, each of which has but N - 1 others around it.
class RadialDistribution {
public:
    ///   reach  the largest distance that is looked at: from the diameter to at most half of the
    ///          side, beyond which a sphere does not fit into the cube  [length]
    ///   bins   equal ones from the diameter to reach
    /// Throws std::invalid_argument outside these limits, or for a cube with walls, near which a
    /// ball has fewer others around it.
    RadialDistribution(System const& system, double reach, int bins);

    void add(Snapshot const& snapshot);

    /// Middle of each bin. [length]
    std::vector<double> distances() const;
    /// Mean of g over each bin's shell; 0 before the first snapshot.
    std::vector<double> values() const;

private:
    System system_;
    double reach_;
    std::vector<std::int64_t> pairs_;
    std::int64_t snapshots_ = 0;
};

/// The value at a place beside given ones, by the polynomial of so high a degree through them that
/// has least squares. From k values on one side of the place, its error is about (degree + 1) /
/// sqrt(k) that of one value.
/// Throws std::invalid_argument unless there are more values than the degree.
double extrapolated(std::vector<double> const& places, std::vector<double> const& values, double to,
                    int degree);

} // namespace clack
