#pragma once
// The dilute limit as a game of chance: balls without places, whose pairs collide at random.

#include <Eigen/Core>

#include <cstdint>
#include <random>

namespace clack::reference {

/// n hard balls of which only the velocities are known. A pair collides at a rate proportional to
/// its relative speed, and its relative velocity then points anywhere: what is left of the motion
/// when the cube is mixed long before a ball meets the next. Exact in law, with no step of time
/// (candidates come at a rate that no pair exceeds, and are taken in proportion). As n grows it
/// solves Boltzmann's equation of a homogeneous gas.
/// Source: M. Kac, Proc. 3rd Berkeley Symp. III, 171 (1956); G. A. Bird, Molecular Gas Dynamics
/// (Oxford, 1976).
class KacWalk {
public:
    enum class Momentum {
        kept,     // a periodic cube
        reflected // walls: before each collision every component has either sign alike
    };

    ///   velocities   3 x n [length / time]
    ///   pair_rate    collisions of one pair per unit time and unit relative speed [1 / length]
    KacWalk(Eigen::Matrix3Xd velocities, double pair_rate, Momentum momentum, std::uint64_t seed);

    /// Goes on to this time since the start.
    void advance(double time);

    Eigen::Matrix3Xd const& velocities() const { return velocities_; }
    std::uint64_t collisions() const { return collisions_; }

private:
    double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    double wait();
    void consider_pair();
    void reflect(Eigen::Index ball);
    Eigen::Vector3d direction();

    Eigen::Matrix3Xd velocities_;
    double candidate_rate_, top_speed_;
    Momentum momentum_;
    std::mt19937_64 random_;
    double next_ = 0;
    std::uint64_t collisions_ = 0;
};

/// The pair rate of two balls in a periodic cube of this volume: pi diameter^2 / volume.
double dilute_pair_rate(double diameter, double volume);

/// The same in a cube with walls, where a ball near a wall is met from one side only: exact for
/// one pair.
///   accessible_side   of the cube that the centres can reach, at least a diameter
double walled_pair_rate(double diameter, double accessible_side);

} // namespace clack::reference
