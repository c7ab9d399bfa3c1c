#include "observables/overlap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace clack {

namespace {

/// The separation of two balls, of nearest images where the cube is periodic.
double distance(System const& system, Eigen::Vector3d separation) {
    if (system.boundary == Boundary::periodic) {
        for (double& along : separation) along -= system.side * std::round(along / system.side);
    }
    return separation.norm();
}

/// Balls sorted into cells at least a diameter wide.
class Cells {
public:
    Cells(System const& system, Eigen::Matrix3Xd const& positions)
        : per_side_(cells_per_side(system)), side_(system.side),
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

private:
    using Coordinates = std::array<std::int64_t, 3>;

    /// With fewer than three a side, a cell would meet another twice through the boundary.
    static std::int64_t cells_per_side(System const& system) {
        double const by_diameter = std::floor(system.side / (system.diameter * (1 + 1e-9)));
        double const by_count = std::ceil(std::cbrt(static_cast<double>(system.count)));
        auto const cells = static_cast<std::int64_t>(std::min(by_diameter, by_count));
        return cells < 3 ? 1 : cells;
    }

    Coordinates coordinates(Eigen::Vector3d const& place) const {
        Coordinates cell{};
        for (std::size_t d = 0; d < 3; ++d) {
            double const along = place[static_cast<Eigen::Index>(d)] / side_;
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

    std::int64_t per_side_;
    double side_;
    std::vector<std::size_t> first_; // of each cell's balls
    std::vector<Eigen::Index> balls_;
};

} // namespace

Overlap deepest_overlap(System const& system, Eigen::Matrix3Xd const& positions) {
    Cells const cells(system, positions);
    Overlap deepest;
    for (Eigen::Index i = 0; i < positions.cols(); ++i) {
        cells.each_near(positions.col(i), [&](Eigen::Index j) {
            if (j <= i) return;
            double const apart = distance(system, positions.col(j) - positions.col(i));
            double const depth = 1 - apart / system.diameter;
            if (depth > deepest.depth) deepest = {depth, i, j};
        });
    }
    return deepest;
}

Excursion farthest_outside(System const& system, Eigen::Matrix3Xd const& positions) {
    double const margin = system.boundary == Boundary::walls ? system.diameter / 2 : 0;
    Excursion farthest;
    for (Eigen::Index i = 0; i < positions.cols(); ++i) {
        for (double const place : positions.col(i)) {
            double const beyond = std::isfinite(place)
                                      ? std::max(margin - place, place - (system.side - margin))
                                      : std::numeric_limits<double>::infinity();
            if (beyond > farthest.distance) farthest = {beyond, i};
        }
    }
    return farthest;
}

} // namespace clack
