#pragma once
// Cells at least one diameter wide: a ball can only touch balls of its own and the 26 cells around.

#include "neighbours/cell_bins.hpp"
#include "neighbours/every_pair.hpp"
#include "neighbours/neighbour_search.hpp"
#include "prediction/sixteen.hpp"
#include "state/container.hpp"

#include <algorithm>
#include <cmath>

namespace clack {

/// How a cube is cut into cells.
template <class Real> struct CellLattice {
    Real origin, side, inverse_side; // of a cell
    std::int32_t per_side;

    /// As many cells as the balls' number wants (`balls_per_cell` on average), never narrower than
    /// `width`, never fewer than four across a periodic cube.
    template <class Container>
    CellLattice(System const& system, Container const& cube, double width, double balls_per_cell) {
        double const extent = static_cast<double>(cube.extent());
        // Wider by what rounding can move a ball, so that none is met from two cells away.
        double const rounding =
            1024 * static_cast<double>(unit_roundoff<Real>) * (system.diameter + system.side);
        double const wanted =
            std::cbrt(balls_per_cell / static_cast<double>(system.count)) * extent;
        double const cells = std::floor(extent / std::max(width + rounding, wanted));
        constexpr double cells_max = 1290; // their cube still fits 31 bits
        constexpr int periodic_min = 4;    // with 3, a pair could touch through two images
        int const least = Container::boundary == Boundary::periodic ? periodic_min : 1;
        per_side = std::max(least, static_cast<int>(std::min(cells, cells_max)));
        origin = cube.origin();
        side = cube.extent() / static_cast<Real>(per_side);
        inverse_side = side > 0 ? 1 / side : Real(0);
    }

    CellBins::Cell cell_at(Vector3<Real> const& place) const {
        CellBins::Cell cell;
        for (int d = 0; d < 3; ++d) {
            auto const raw = static_cast<std::int32_t>((place[d] - origin) * inverse_side);
            cell[static_cast<std::size_t>(d)] = std::clamp(raw, 0, per_side - 1);
        }
        return cell;
    }
};

/// Balls by cell; a ball that leaves its cell expires.
template <class Real, class Container> class CellGrid {
public:
    CellGrid(System const& system, Container const& cube)
        : cube_(cube), lattice_(system, cube, system.diameter, balls_per_cell),
          bins_(Container::boundary, lattice_.per_side, static_cast<std::size_t>(system.count)),
          exit_(static_cast<std::size_t>(system.count)) {}

    /// From five cells across on: with four, candidates may be half a side away.
    bool nearest_image_is_clear() const {
        return Container::boundary == Boundary::walls || lattice_.per_side > 4;
    }

    void rebuild(std::vector<Ball<Real>> const& balls, Real now) {
        bins_.clear();
        for (std::size_t i = 0; i < balls.size(); ++i) {
            Vector3<Real> place = balls[i].position(now);
            cube_.wrap(place);
            bins_.insert(static_cast<std::int32_t>(i), lattice_.cell_at(place));
        }
    }

    std::span<std::int32_t const> candidates(std::int32_t ball) {
        BallBuffer& found = next_buffer();
        bins_.collect_around(bins_.cell_of(ball), found);
        return padded(found, ball);
    }

    /// When the ball leaves its cell. The cell is what the last crossing said, never what the
    /// coordinate says: that may lie an ulp on either side.
    Real expiry(std::vector<Ball<Real>> const& balls, std::int32_t ball, Real now) {
        Ball<Real> const& record = balls[static_cast<std::size_t>(ball)];
        CellBins::Cell const& cell = bins_.cell_of(ball);
        Real const flown = now - record.time;
        Real first = infinity<Real>;
        int axis = 0;
        for (int d = 0; d < 3; ++d) {
            // Choices, not branches: which way a ball flies cannot be foretold.
            Real const v = record.velocity[d];
            std::int32_t const ahead = cell[static_cast<std::size_t>(d)] + (v > 0 ? 1 : 0);
            Real distance = lattice_.origin + static_cast<Real>(ahead) * lattice_.side -
                            (record.point[d] + v * flown);
            bool never = v == 0;
            if constexpr (Container::boundary == Boundary::periodic) {
                distance -= cube_.image(distance) * cube_.side;
            } else {
                never |= ahead == 0 || ahead == lattice_.per_side;
            }
            Real const wait = distance / v;
            Real const when = never ? infinity<Real> : now + (wait > 0 ? wait : Real(0));
            bool const sooner = when < first;
            first = sooner ? when : first;
            axis = sooner ? d : axis;
        }
        exit_[static_cast<std::size_t>(ball)] = static_cast<std::uint8_t>(axis);
        return first;
    }

    /// Moves the ball to the next cell along the axis it leaves by; only the nine cells behind the
    /// new face can hold balls that it could not touch before.
    std::span<std::int32_t const> refresh(std::vector<Ball<Real>> const& balls, std::int32_t ball,
                                          Real) {
        std::size_t const d = exit_[static_cast<std::size_t>(ball)];
        Real const v = balls[static_cast<std::size_t>(ball)].velocity[static_cast<int>(d)];
        std::int32_t const direction = v > 0 ? 1 : -1;
        CellBins::Cell cell = bins_.cell_of(ball);
        cell[d] = bins_.next(cell[d], direction);
        bins_.remove(ball);
        bins_.insert(ball, cell);
        BallBuffer& found = next_buffer();
        bins_.collect_beyond(cell, d, direction, found);
        return padded(found, ball);
    }

    std::size_t bytes() const {
        return bins_.bytes() + exit_.capacity() + buffers_[0].bytes() + buffers_[1].bytes();
    }

private:
    // Fewer make crossings, more make candidates: the flat optimum of their cost together.
    static constexpr double balls_per_cell = 1;

    BallBuffer& next_buffer() {
        turn_ = 1 - turn_;
        buffers_[turn_].clear();
        return buffers_[turn_];
    }
    std::span<std::int32_t const> padded(BallBuffer& found, std::int32_t ball) {
        if (found.size() == 0) found.append(ball);
        found.pad(ball, screen_lanes);
        return {found.begin(), found.size()};
    }

    Container cube_;
    CellLattice<Real> lattice_;
    CellBins bins_;
    std::vector<std::uint8_t> exit_;    // the axis along which the ball will leave its cell
    std::array<BallBuffer, 2> buffers_; // reused in turn
    std::size_t turn_ = 0;
};

} // namespace clack
