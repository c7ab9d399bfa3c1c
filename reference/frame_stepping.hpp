#pragma once
// Balls moved as games do it: all of them by a step of time, then whatever overlaps is set right.
// What an event-driven engine is compared with, and no part of it.

#include "state/checkpoint.hpp"
#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace clack::reference {

/// Equal elastic balls in steps of time. A step moves all balls along straight lines. A ball beyond
/// a wall is mirrored at it, which is exact. A pair that overlaps and approaches exchanges the
/// normal components of its velocities where it stands, and a pair that overlaps is drawn apart
/// along its line of centres until it touches, so that it is not met again. The order of the pairs
/// is that of a grid of cells, which is made anew in each step.
///
/// The error of a collision is of the first order in the step; collisions that begin and end within
/// a step are missed, and pairs that push each other go through without end where balls are dense.
/// Energy is kept to rounding.
class FrameStepping {
public:
    ///   step   [time], positive; a ball should not fly further in it than its diameter
    /// Throws std::invalid_argument unless the step is positive.
    FrameStepping(System const& system, Start start, double step);

    void advance(std::int64_t steps);

    double time() const { return static_cast<double>(steps_) * step_; }
    /// As an engine has it: periodic places are wrapped.
    Start const& balls() const { return balls_; }
    /// The deepest overlap is that which a step left to be set right.
    Tallies const& tallies() const { return tallies_; }
    /// Pairs that have collided, lower number first, in their order; walls are left out.
    std::vector<std::array<std::int64_t, 2>> const& pairs() const { return pairs_; }

private:
    void move();
    void sort_into_cells();
    void meet_neighbours(std::int64_t ball);
    void meet(std::int64_t i, std::int64_t j);
    std::int64_t cell_of(Eigen::Vector3d const& place) const;
    Eigen::Vector3d separation(std::int64_t i, std::int64_t j) const;

    System system_;
    Start balls_;
    double step_;
    std::int64_t steps_ = 0;
    Tallies tallies_;
    std::vector<std::array<std::int64_t, 2>> pairs_;
    std::int64_t cells_; // along a side
    std::vector<std::int64_t> first_in_cell_, next_in_cell_;
};

} // namespace clack::reference
