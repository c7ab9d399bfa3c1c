#pragma once
// How a small difference between two runs grows: one vector of tangent space, carried along a run.

#include "simulation/engine.hpp"

#include <vector>

namespace clack {

/// An infinitesimal difference of all places and velocities, moved along with a run from its
/// collision records alone. Between collisions a difference in velocity becomes one in place; a
/// collision turns the difference by the derivative of what it does to the balls, its moment
/// included; a wall mirrors it. Positions of the run are not needed, only separations at contact.
///
/// Source of the map at a collision: Ch. Dellago, H. A. Posch, W. G. Hoover, Phys. Rev. E 53, 1485
/// (1996), doi:10.1103/PhysRevE.53.1485.
class TangentVector final : public CollisionObserver {
public:
    /// Differences at a moment of the run, column i being ball number i.  [length], [length / time]
    ///   time   of that moment, as the run's clock has it
    TangentVector(System const& system, Eigen::Matrix3Xd places, Eigen::Matrix3Xd velocities,
                  double time = 0);

    void operator()(Collision<double> const& collision) override;

    /// Brings all differences to one moment, not before the last collision.
    void move_to(double time);

    /// Both of the moment that `move_to` brought them to.
    Eigen::Matrix3Xd const& places() const { return places_; }
    Eigen::Matrix3Xd const& velocities() const { return velocities_; }

    /// Shrinks the vector to length 1 in phase space and returns the logarithm of what it was. Any
    /// length would do: growth is linear. Lengths are in diameters, times in `time_unit`.
    double normalise(double time_unit = 1);

private:
    void fly(std::int64_t ball, double time);

    System system_;
    Eigen::Matrix3Xd places_, velocities_;
    std::vector<double> times_; // until which each ball's difference has been moved
};

} // namespace clack
