#pragma once
// Cells at least one diameter wide: a ball can only touch balls of its own and the 26 cells around.

#include "neighbours/cell_bins.hpp"
#include "neighbours/cell_lattice.hpp"
#include "neighbours/neighbour_search.hpp"
#include "prediction/lanes.hpp"
#include "state/container.hpp"

#include <algorithm>
#include <cmath>

namespace clack {

/// Balls by cell; a ball that has left its cell expires, but not at once. Cells are wider than a
/// diameter where balls are few, and as far as half of what they are wider each ball may stray from
/// its own: those that touch are in adjacent cells still. So a ball that turns soon never crosses.
/// Measured at packing fractions 0.01, 0.05, 0.10 and 0.20: 1.13 to 1.16, 1.13 to 1.17, 1.18 to
/// 1.23 and 1.07 to 1.09 times as fast.
template <class Real, class Container> class CellGrid {
public:
    CellGrid(System const& system, Container const& cube)
        : cube_(cube),
          lattice_(system, cube, CellLattice<Real>::reach(system), balls_per_cell, periodic_min),
          bins_(Container::boundary, lattice_.per_side, static_cast<std::size_t>(system.count)),
          coarsest_(lattice_.per_side), reach_(CellLattice<Real>::reach(system)),
          origin_(static_cast<double>(lattice_.origin)),
          cell_side_(static_cast<double>(lattice_.side)), side_(system.side),
          inverse_side_(1 / system.side) {}

    /// Whether a periodic cube is wide enough.
    static bool fits(System const& system) {
        return system.boundary == Boundary::walls ||
               system.side > (periodic_min + 0.1) * system.diameter;
    }

    /// Balls that stand close together in a wide cube want narrower cells than their number says,
    /// or all of them would be candidates of each.
    void rebuild(std::vector<Ball<Real>> const& balls, Real now) {
        crossings_ = 0;
        std::int32_t cells = coarsest_;
        cut_into(cells, balls, now);
        while (cells >= 3 && 2 * cells <= lattice_.finest && crowded()) {
            cells *= 2;
            cut_into(cells, balls, now);
        }
    }

    std::span<std::int32_t const> candidates(std::int32_t ball) {
        return candidates_in(found_, ball);
    }
    std::array<std::span<std::int32_t const>, 2> candidates_of_both(std::int32_t i,
                                                                    std::int32_t j) {
        return {candidates_in(found_, i), candidates_in(also_found_, j)};
    }

    /// When the ball has strayed too far from its cell, which is what the last crossing said, never
    /// what the coordinate says: that may lie an ulp on either side.
    Real expiry(std::vector<Ball<Real>> const& balls, std::int32_t ball, Real now) {
        Ball<Real> const& record = balls[static_cast<std::size_t>(ball)];
        // Three axes at once and choices, not branches: which way a ball flies cannot be foretold.
        using Numbers = Fours<double>;
        double const inf = infinity<double>;
        Numbers const v = velocity_in_double(record);
        Numbers const place = point_in_double(record) + v * static_cast<double>(now - record.time);
        Numbers const ahead = bins_.cell_as_four(ball) + (v > 0.0 ? Numbers{1, 1, 1} : Numbers{});
        Numbers const beyond = v > 0.0 ? Numbers{} + stray_ : Numbers{} - stray_;
        Numbers distance = origin_ + ahead * cell_side_ + beyond - place;
        auto never = v == 0.0;
        if constexpr (Container::boundary == Boundary::periodic) {
            distance -= nearest_integer<Numbers, double>(distance * inverse_side_) * side_;
        } else {
            never |= (ahead == 0.0) | (ahead == static_cast<double>(lattice_.per_side));
        }
        Numbers wait = distance / v;
        wait = wait > 0.0 ? wait : Numbers{};
        wait = never ? Numbers{inf, inf, inf, inf} : wait;
        std::int32_t const y_first = wait[1] < wait[0];
        double const in_xy = std::min(wait[0], wait[1]);
        std::int32_t const z_first = wait[2] < in_xy;
        double const first = std::min(in_xy, wait[2]);
        std::int32_t const axis = 2 * z_first + (y_first & (1 - z_first)); // a sum is no branch
        bins_.note(ball, axis);
        return now + static_cast<Real>(first);
    }

    /// Takes a ball that is about to be predicted anew, from all its candidates, back to the cell
    /// in which it is now.
    void settle(std::vector<Ball<Real>> const& balls, std::int32_t ball) {
        Cell const cell = lattice_.cell_at(balls[static_cast<std::size_t>(ball)].point);
        Cell const& old = bins_.cell_of(ball);
        if (((cell[0] ^ old[0]) | (cell[1] ^ old[1]) | (cell[2] ^ old[2])) == 0) return;
        bins_.remove(ball);
        bins_.insert(ball, cell);
    }

    /// Moves the ball to the next cell along the axis it leaves by; only the nine cells behind the
    /// new face can hold balls that it could not touch before.
    std::span<std::int32_t const> refresh(std::vector<Ball<Real>> const& balls, std::int32_t ball,
                                          Real) {
        ++crossings_;
        Crossing const crossing = crossing_of(balls, ball);
        bins_.remove(ball);
        bins_.insert(ball, crossing.to);
        found_.clear();
        bins_.collect_beyond(crossing.to, crossing.axis, crossing.direction, found_);
        return padded(found_, ball);
    }

    /// Whether narrow cells have been crossed so often that it is worth a look whether the balls
    /// still stand close together.
    bool wants_rebuild() const {
        return lattice_.per_side > coarsest_ && crossings_ > 64 * bins_.ball_count();
    }

    /// Hints to the memory: a ball's own entries, and what `candidates`, at a time that is to come,
    /// and `refresh` will read.
    void fetch(std::int32_t ball) const { bins_.fetch(ball); }
    void fetch_candidates(std::vector<Ball<Real>> const& balls, std::int32_t ball,
                          Real time) const {
        bins_.fetch_around(cell_at(balls, ball, time));
    }
    void fetch_for_refresh(std::vector<Ball<Real>> const& balls, std::int32_t ball) const {
        Crossing const crossing = crossing_of(balls, ball);
        bins_.fetch_own(ball);
        bins_.fetch_beyond(crossing.to, crossing.axis, crossing.direction);
    }

    /// And the records of the balls that those two will find. They are gathered for it: a look into
    /// each cell for whether it holds one costs twice as much, since that cannot be foretold.
    void fetch_records(std::vector<Ball<Real>> const& balls, std::int32_t ball, Real time) {
        found_.clear();
        bins_.collect_around(cell_at(balls, ball, time), found_);
        fetch_records_of_found(balls);
    }
    /// Of two balls that touch, whose surroundings are nearly the same.
    void fetch_records(std::vector<Ball<Real>> const& balls, std::int32_t i, std::int32_t j,
                       Real time) {
        Cell const first = cell_at(balls, i, time), second = cell_at(balls, j, time);
        found_.clear();
        bins_.collect_around(first, found_);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::int32_t const way = second[axis] - first[axis]; // one cell, or all through a face
            if (way != 0) bins_.collect_beyond(second, axis, way == 1 || way < -1 ? 1 : -1, found_);
        }
        fetch_records_of_found(balls);
    }
    void fetch_fresh_records(std::vector<Ball<Real>> const& balls, std::int32_t ball) {
        Crossing const crossing = crossing_of(balls, ball);
        found_.clear();
        bins_.collect_beyond(crossing.to, crossing.axis, crossing.direction, found_);
        fetch_records_of_found(balls);
    }

    std::size_t bytes() const { return bins_.bytes() + found_.bytes() + also_found_.bytes(); }

private:
    // With four, balls in adjacent cells can be exactly half a side apart: then either image is the
    // nearest, and the pair meets through the one that was not looked at.
    static constexpr int periodic_min = 5;

    // Fewer make crossings, more make candidates. Measured against 1: as fast at packing fraction
    // 0.01, 1.04 times at 0.05, 1.12 times at 0.20.
    static constexpr double balls_per_cell = 0.6;

    struct Crossing {
        std::size_t axis = 0;
        std::int32_t direction = 0;
        Cell to{};
    };
    Crossing crossing_of(std::vector<Ball<Real>> const& balls, std::int32_t ball) const {
        Crossing crossing{.to = bins_.cell_of(ball)};
        crossing.axis = static_cast<std::size_t>(crossing.to[3]);
        Real const velocity =
            balls[static_cast<std::size_t>(ball)].velocity[static_cast<int>(crossing.axis)];
        crossing.direction = velocity > 0 ? 1 : -1;
        crossing.to[crossing.axis] = bins_.next(crossing.to[crossing.axis], crossing.direction);
        return crossing;
    }

    void cut_into(std::int32_t cells, std::vector<Ball<Real>> const& balls, Real now) {
        if (cells != lattice_.per_side) {
            lattice_.set_cells(cube_, cells);
            bins_.lay_out(cells);
            cell_side_ = static_cast<double>(lattice_.side);
        }
        stray_ = 0.5 * std::max(0.0, cell_side_ - reach_);
        // The nearest image of balls in adjacent cells must be the one through which they touch.
        if constexpr (Container::boundary == Boundary::periodic)
            stray_ = std::min(stray_, 0.99 * (0.25 * cells - 1) * cell_side_);
        bins_.clear();
        for (std::int32_t i = 0; i < static_cast<std::int32_t>(balls.size()); ++i)
            bins_.insert(i, cell_at(balls, i, now));
    }

    /// Where a ball is, or will be if it meets nothing.
    Cell cell_at(std::vector<Ball<Real>> const& balls, std::int32_t ball, Real time) const {
        Vector3<Real> place = balls[static_cast<std::size_t>(ball)].position(time);
        cube_.wrap(place);
        return lattice_.cell_at(place);
    }

    void fetch_records_of_found(std::vector<Ball<Real>> const& balls) const {
        for (std::int32_t const other : found_) prefetch(balls.data() + other);
    }

    /// Whether a ball has many candidates, as a sample of them tells.
    bool crowded() {
        constexpr std::size_t sample = 256, many = 100;
        std::size_t const step = std::max<std::size_t>(1, bins_.ball_count() / sample);
        std::size_t seen = 0, asked = 0;
        for (std::size_t ball = 0; ball < bins_.ball_count(); ball += step, ++asked)
            seen += candidates(static_cast<std::int32_t>(ball)).size();
        return seen > many * asked;
    }

    std::span<std::int32_t const> candidates_in(BallBuffer& found, std::int32_t ball) {
        found.clear();
        bins_.collect_around(bins_.cell_of(ball), found);
        return padded(found, ball);
    }
    static std::span<std::int32_t const> padded(BallBuffer& found, std::int32_t ball) {
        found.template pad<lane_count>(ball);
        return {found.begin(), found.size()};
    }

    Container cube_;
    CellLattice<Real> lattice_;
    CellBins<3> bins_;          // noted there: the axis along which a ball will leave its cell
    std::int32_t coarsest_;     // cells across the cube
    std::size_t crossings_ = 0; // since the last rebuild
    double reach_;              // centres farther apart than this do not touch
    double stray_ = 0;          // how far a ball may be from its cell
    double origin_, cell_side_, side_, inverse_side_; // an index needs no more than double
    BallBuffer found_, also_found_;                   // reused
};

} // namespace clack
