#pragma once
// Places of a run with all the digits that it has, and places moved by less than a double shows.

#include "state/checkpoint.hpp"
#include "state/real.hpp"
#include "state/system.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace clack::validation {

using QuadPlaces = Eigen::Matrix<quad, 3, Eigen::Dynamic>;

/// One number of a checkpoint, of whatever type: the record's 0-2 its point, 3-5 its velocity, 6
/// when it holds.
inline quad record_number(Checkpoint const& checkpoint, Eigen::Index ball, int which) {
    quad sum = 0;
    auto const limbs = static_cast<std::size_t>(checkpoint.limbs);
    std::size_t const first =
        (7 * static_cast<std::size_t>(ball) + static_cast<std::size_t>(which)) * limbs;
    for (std::size_t limb = limbs; limb-- > 0;) sum += quad(checkpoint.records[first + limb]);
    return sum;
}

/// Where all balls are at a time, not before the checkpoint's and before anything happens; without
/// the rounding of the run's own type. Periodic places are as if nothing had been wrapped.
inline QuadPlaces exact_places(Checkpoint const& checkpoint, System const& system, double time) {
    QuadPlaces places(3, system.count);
    quad const within = quad(time) - quad(checkpoint.epoch_length) * quad(checkpoint.epoch);
    for (Eigen::Index ball = 0; ball < places.cols(); ++ball) {
        quad const flown = within - record_number(checkpoint, ball, 6);
        for (int d = 0; d < 3; ++d)
            places(d, ball) = record_number(checkpoint, ball, d) +
                              record_number(checkpoint, ball, 3 + d) * flown +
                              quad(system.side) * quad(checkpoint.images(d, ball));
    }
    return places;
}

/// Twice the kinetic energy by unit mass, without a rounding of double's.
inline quad exact_square_speed(Checkpoint const& checkpoint, System const& system) {
    quad sum = 0;
    for (Eigen::Index ball = 0; ball < system.count; ++ball)
        for (int d = 3; d < 6; ++d) {
            quad const v = record_number(checkpoint, ball, d);
            sum += v * v;
        }
    return sum;
}

/// Distance between the places of each ball.  [length]
inline std::vector<double> distances(QuadPlaces const& places, QuadPlaces const& others) {
    std::vector<double> all;
    for (Eigen::Index ball = 0; ball < places.cols(); ++ball) {
        Vector3<quad> const apart = places.col(ball) - others.col(ball);
        all.push_back(static_cast<double>(sqrt(dot<quad>(apart, apart))));
    }
    return all;
}

/// Moves the places of a checkpoint in quad by so little that its last limbs alone change.
inline void displace(Checkpoint& checkpoint, Eigen::Matrix3Xd const& by) {
    auto const limbs = static_cast<Eigen::Index>(checkpoint.limbs);
    for (Eigen::Index ball = 0; ball < by.cols(); ++ball)
        for (Eigen::Index d = 0; d < 3; ++d)
            checkpoint.records[static_cast<std::size_t>((7 * ball + d + 1) * limbs - 1)] +=
                by(d, ball);
}

} // namespace clack::validation
