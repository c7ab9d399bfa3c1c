#pragma once
// Which balls of one instant are near each other, from places alone: nothing of the engine's is
// used.

#include "state/system.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace clack {

/// Balls sorted into cells at least `reach` wide. Holds references to its arguments.
class NearCells {
public:
    NearCells(System const& system, Eigen::Matrix3Xd const& positions, double reach)
        : system_(system), positions_(positions), per_side_(cells_per_side(system, reach)),
          first_(static_cast<std::size_t>(per_side_ * per_side_ * per_side_) + 1) {
        std::vector<std::size_t> cell_of(static_cast<std::size_t>(positions.cols()));
        for (std::size_t i = 0; i < cell_of.size(); ++i) {
            cell_of[i] = index(coordinates(positions.col(static_cast<Eigen::Index>(i))));
            ++first_[cell_of[i] + 1];
        }
        for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
        balls_.resize(cell_of.size());
        auto next = first_;
        for (std::size_t i = 0; i < cell_of.size(); ++i) {
            balls_[next[cell_of[i]]++] = static_cast<Eigen::Index>(i);
        }
    }

    /// Calls visit(i, j, place of j - place of i), i < j, once for every pair that may be within
    /// reach, and for others. The separation is that of nearest images where the cube is periodic.
    template <class Visit> void each_pair(Visit const& visit) const {
        for (Eigen::Index i = 0; i < positions_.cols(); ++i) {
            each_near(positions_.col(i), [&](Eigen::Index j) {
                if (j > i) visit(i, j, nearest(positions_.col(j) - positions_.col(i)));
            });
        }
    }

private:
    using Coordinates = std::array<std::int64_t, 3>;

    /// Calls visit(j) for all balls in the cell of a place and those around it, once each.
    template <class Visit> void each_near(Eigen::Vector3d const& place, Visit const& visit) const {
        auto const centre = coordinates(place);
        auto const reach =
            std::min<std::int64_t>(per_side_ / 2, 1); // one cell is its own neighbour
        for (auto x = centre[0] - reach; x <= centre[0] + reach; ++x) {
            for (auto y = centre[1] - reach; y <= centre[1] + reach; ++y) {
                for (auto z = centre[2] - reach; z <= centre[2] + reach; ++z) {
                    auto const cell = index({wrapped(x), wrapped(y), wrapped(z)});
                    for (auto k = first_[cell]; k < first_[cell + 1]; ++k) visit(balls_[k]);
                }
            }
        }
    }

    Eigen::Vector3d nearest(Eigen::Vector3d separation) const {
        if (system_.boundary == Boundary::periodic) {
            for (double& along : separation)
                along -= system_.side * std::round(along / system_.side);
        }
        return separation;
    }

    /// With fewer than three a side, a cell would meet another twice through the boundary.
    static std::int64_t cells_per_side(System const& system, double reach) {
        double const by_reach = std::floor(system.side / (reach * (1 + 1e-9)));
        double const by_count = std::ceil(std::cbrt(static_cast<double>(system.count)));
        auto const cells = static_cast<std::int64_t>(std::min(by_reach, by_count));
        return cells < 3 ? 1 : cells;
    }

    Coordinates coordinates(Eigen::Vector3d const& place) const {
        Coordinates cell{};
        for (std::size_t d = 0; d < 3; ++d) {
            double const along = place[static_cast<Eigen::Index>(d)] / system_.side;
            auto const last = static_cast<double>(per_side_ - 1);
            // Not a number goes to the first cell; it is told elsewhere.
            double const k = std::floor(along * static_cast<double>(per_side_));
            cell[d] = k > 0 ? static_cast<std::int64_t>(std::min(k, last)) : 0;
        }
        return cell;
    }

    std::int64_t wrapped(std::int64_t k) const { return (k + per_side_) % per_side_; }

    std::size_t index(Coordinates const& cell) const {
        return static_cast<std::size_t>((cell[0] * per_side_ + cell[1]) * per_side_ + cell[2]);
    }

    System const& system_;
    Eigen::Matrix3Xd const& positions_;
    std::int64_t per_side_;
    std::vector<std::size_t> first_; // of each cell's balls
    std::vector<Eigen::Index> balls_;
};

} // namespace clack
