#pragma once
// Helfand's moments: what carries momentum and heat through a fluid, added up along a run.

#include "simulation/engine.hpp"
#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <Eigen/Core>

namespace clack {

/// Time integrals of the flux of momentum and of heat through the whole of a periodic fluid,
///   stress: sum over balls of m v v dt, and separation x impulse at each collision;
///   heat:   sum over balls of (m/2) v^2 v dt, and separation x energy handed on at each collision.
/// Their mean squares grow with time as the transport coefficients say. Without external forces
/// and with zero total momentum; walls are ignored.
/// Source: E. Helfand, Phys. Rev. 119, 1 (1960).
class HelfandMoments : public CollisionObserver {
public:
    /// From the present state of a run.
    HelfandMoments(System const& system, Snapshot const& now);

    void operator()(Collision<double> const& collision) override;

    /// Since the beginning, at a time not before the last collision seen.
    Eigen::Matrix3d stress(double time) const { return stress_ + kinetic_ * (time - time_); }
    Eigen::Vector3d heat(double time) const { return heat_ + carried_ * (time - time_); }

private:
    void add_ball(Eigen::Vector3d const& velocity, double sign);

    double mass_;
    double time_;
    Eigen::Matrix3d stress_ = Eigen::Matrix3d::Zero(); // up to time_
    Eigen::Vector3d heat_ = Eigen::Vector3d::Zero();
    Eigen::Matrix3d kinetic_ = Eigen::Matrix3d::Zero(); // flux by flight, since time_
    Eigen::Vector3d carried_ = Eigen::Vector3d::Zero();
};

} // namespace clack
