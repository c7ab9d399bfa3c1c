#pragma once
// How far balls go and how long they remember their velocity.

#include "state/snapshot.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <deque>
#include <vector>

namespace clack {

/// Mean square displacement and velocity autocorrelation, as means over balls and over origins of
/// time. Eats snapshots at equal intervals of time; the interval between them is the unit of a lag.
class SelfCorrelation {
public:
    ///   side             of the periodic cube, to unwrap the places; 0 with walls [length]
    ///   lag_max          longest lag, in intervals
    ///   origin_spacing   every so manieth snapshot is an origin
    SelfCorrelation(double side, std::size_t lag_max, std::size_t origin_spacing);

    void add(Snapshot const& snapshot);

    std::size_t lag_max() const { return displacement_.size() - 1; }
    /// <|x(t) - x(0)|^2> [length^2], of all three components together; 0 at lag 0.
    double mean_square_displacement(std::size_t lag) const;
    /// <v(t) . v(0)> [length^2 / time^2].
    double velocity_autocorrelation(std::size_t lag) const;

private:
    struct Origin {
        std::size_t index;
        Eigen::Matrix3Xd positions, velocities;
    };

    double side_;
    std::size_t origin_spacing_;
    std::size_t seen_ = 0;
    std::deque<Origin> origins_;
    std::vector<double> displacement_, velocity_, counts_;
};

} // namespace clack
