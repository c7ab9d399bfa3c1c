#pragma once
// How many balls there are at a distance from a wall.

#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <cstdint>
#include <vector>

namespace clack {

/// Eats snapshots of a run between walls: the density of centres against the distance from a wall,
/// mean over the six faces.
class DensityProfile {
public:
    ///   reach  the largest distance of a centre from the wall: from half a diameter, the nearest
    ///          that there is, to at most half of the side  [length]
    ///   bins   equal ones
    ///   inset  balls nearer than this to where centres stop at another wall are left out, so that
    ///          edges are not seen; with 0 the whole face is  [length]
    /// Throws std::invalid_argument outside these limits, or for a periodic cube.
    DensityProfile(System const& system, double reach, int bins, double inset = 0);

    void add(Snapshot const& snapshot);

    /// Middle of each bin. [length]
    std::vector<double> distances() const;
    /// Mean density in each bin; 0 before the first snapshot. [1 / length^3]
    std::vector<double> values() const;

private:
    double bin_width() const;

    System system_;
    double reach_, inset_;
    std::vector<std::int64_t> balls_;
    std::int64_t snapshots_ = 0;
};

/// Balls per volume in the middle of the cube: a mean over half_width to each side of its centre
/// along each axis, in which places count less the farther out they are (as the square of a
/// cosine), so that the layers beside walls average out.
double density_in_the_middle(System const& system, Snapshot const& snapshot, double half_width);

} // namespace clack
