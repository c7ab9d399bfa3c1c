#pragma once
// Equal balls on a line between two walls, solved exactly for all times.

#include "reference/triangle_wave.hpp"

#include <cstdint>
#include <vector>

namespace clack::reference {

/// n equal balls whose centres stay on one line between two walls. Equal balls swap velocities, so
/// points that pass through one another (ghosts) trace the same set of paths: with all balls shrunk
/// to points, the i-th ball is the i-th ghost from the left. Exact at all times.
/// Source: L. Tonks, Phys. Rev. 50, 955 (1936), for the shrinking; D. W. Jepsen, J. Math. Phys. 6,
/// 405 (1965), for the ghosts.
class GhostChain {
public:
    ///   side         wall to wall [length]
    ///   diameter     [length]
    ///   positions    of the centres, from left to right, at least a diameter apart [length]
    ///   velocities   [length / time]
    /// Throws std::invalid_argument unless the balls fit in order without overlap.
    GhostChain(double side, double diameter, std::vector<double> const& positions,
               std::vector<double> const& velocities);

    /// Centres at a time, from left to right: ball i is the i-th.
    std::vector<double> positions(double time) const;
    /// Velocities of the same balls.
    std::vector<double> velocities(double time) const;
    /// Ball-ball collisions in (0, time]: the times that two ghosts pass each other.
    std::int64_t ball_collisions(double time) const;
    /// Ball-wall collisions in (0, time], both walls.
    std::int64_t wall_collisions(double time) const;

private:
    struct Ghost {
        double place, velocity;
    };
    std::vector<Ghost> in_order(double time) const;
    double diameter_;
    std::vector<TriangleWave> ghosts_;
};

} // namespace clack::reference
