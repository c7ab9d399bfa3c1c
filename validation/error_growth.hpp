#pragma once
// How far a type can follow the exact motion at best, by tangent space: one rounding of the start,
// grown along the very run, until it decides whom the balls meet.

#include "observables/tangent_vector.hpp"
#include "validation/lattice_start.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace clack::validation {

/// Probability that a meeting does not happen, by the error of the separation of the two, where
/// errors point anywhere, so that of an error r the mean in one sense along a line is r / 4:
/// the two miss each other, 2 / d of that where impact parameters are spread over a disc; one of
/// the two hits another that it would have missed, as often each; one of the two meets first
/// another that would have come later, as likely as the times of two contacts, each off by an error
/// over the mean normal speed, change their order in a mean free time, r / (pi l) each.
///   mean_free_path  [length]
inline double risk_of_error(System const& system, double const mean_free_path) {
    double const misses = 3 / (2 * system.diameter);
    return misses + 2 / (std::numbers::pi * mean_free_path);
}

/// Follows a run with the difference that one rounding of each number of its start makes, up or
/// down. Growth is linear, so one such run serves all types.
class ErrorGrowth final : public CollisionObserver {
public:
    ///   mean_free_path  [length]
    ErrorGrowth(System const& system, Start const& start, double const mean_free_path,
                std::uint64_t const seed)
        : vector_(system, rounded(start.positions, seed), rounded(start.velocities, seed + 1)),
          count_(static_cast<std::size_t>(system.count)),
          risk_(risk_of_error(system, mean_free_path)) {}

    void operator()(Collision<double> const& collision) override {
        vector_(collision);
        if (collision.kind != CollisionKind::ball) return;
        Eigen::Vector3d const apart =
            vector_.places().col(collision.second) - vector_.places().col(collision.first);
        meetings_.push_back({static_cast<std::size_t>(collision.first),
                             static_cast<std::size_t>(collision.second), risk_ * apart.norm()});
    }

    /// Collisions per ball that a run from the rounded start has in common with this one, as is to
    /// be expected. A ball that has missed a meeting spoils all that it was to have after: a little
    /// too strict, since in a dense fluid some of them happen all the same.
    /// NaN where the run is too short for the balls to lose it.
    ///   unit  of rounding
    double limit(double const unit, std::uint64_t const seed) const {
        constexpr int draws = 32; // of which meetings are lost: their luck is 1 % of the limit
        std::mt19937_64 random(seed);
        std::uint64_t kept = 0;
        std::size_t on_their_way = 0;
        for (int draw = 0; draw < draws; ++draw) {
            std::vector<bool> strayed(count_);
            for (auto const& [i, j, risk] : meetings_) {
                bool const lost = strayed[i] || strayed[j] || uniform(random) < unit * risk;
                strayed[i] = strayed[j] = lost;
                kept += lost ? 0 : 2;
            }
            on_their_way +=
                static_cast<std::size_t>(std::count(strayed.begin(), strayed.end(), false));
        }
        auto const all = static_cast<double>(draws) * static_cast<double>(count_);
        constexpr double few = 0.01;
        if (static_cast<double>(on_their_way) > few * all)
            return std::numeric_limits<double>::quiet_NaN();
        return static_cast<double>(kept) / all;
    }

private:
    struct Meeting {
        std::size_t first, second;
        double risk; // of being lost, per unit of rounding
    };

    static Eigen::Matrix3Xd rounded(Eigen::Matrix3Xd numbers, std::uint64_t const seed) {
        std::mt19937_64 random(seed);
        for (double& number : numbers.reshaped())
            if (uniform(random) < 0.5) number = -number;
        return numbers;
    }

    TangentVector vector_;
    std::size_t count_;
    double risk_; // of a meeting by the error of its separation  [1 / length]
    std::vector<Meeting> meetings_;
};

} // namespace clack::validation
