#pragma once
// Each ball's own list of balls near it, good until it leaves the shell around the list's centre.

#include "neighbours/cell_bins.hpp"
#include "neighbours/cell_lattice.hpp"
#include "neighbours/neighbour_search.hpp"
#include "neighbours/shells.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace clack {

/// Two balls are in each other's lists when the centres of their shells lie within a diameter and
/// two shell radii: while both stay inside their shells, no other pair can touch. A ball that
/// leaves its shell gets a new list about where it is, alone.
template <class Real, class Container> class NeighbourList {
public:
    static constexpr bool candidates_are_near = true; // within three diameters, most often

    NeighbourList(System const& system, Container const& cube)
        : NeighbourList(system, cube, Shell(system)) {}

    /// Whether a periodic cube is wide enough for the nearest image to be the only one in reach.
    static bool fits(System const& system) {
        return system.boundary == Boundary::walls ||
               system.side > (periodic_min + 0.1) * Shell(system).reach;
    }

    void rebuild(std::vector<Ball<Real>> const& balls, Real now) {
        bins_.clear();
        for (std::size_t i = 0; i < balls.size(); ++i) {
            auto const ball = static_cast<std::int32_t>(i);
            shells_.put(ball, balls[i].position(now));
            bins_.insert(ball, lattice_.cell_at(shells_.centre(ball)));
        }
        for (std::int32_t i = 0; i < static_cast<std::int32_t>(balls.size()); ++i)
            write(i, near(i));
    }

    /// A list holds as long as its ball is in its shell, wherever it flies.
    void settle(std::vector<Ball<Real>> const&, std::int32_t) {}

    std::span<std::int32_t const> candidates(std::int32_t ball) const {
        std::int32_t const* const list = row(ball);
        std::size_t end = line_balls;
        while (end < width_ && list[end - 1] != ball && list[end] != ball) end += line_balls;
        return {list, end};
    }

    std::array<std::span<std::int32_t const>, 2> candidates_of_both(std::int32_t i,
                                                                    std::int32_t j) const {
        return {candidates(i), candidates(j)};
    }

    Real expiry(std::vector<Ball<Real>> const& balls, std::int32_t ball, Real now) const {
        return shells_.expiry(ball, balls[static_cast<std::size_t>(ball)], now);
    }
    /// Of two balls that were written at `now`.
    std::array<Real, 2> expiries(std::vector<Ball<Real>> const& balls, std::int32_t i,
                                 std::int32_t j, Real now) const {
        return shells_.expiries(i, balls[static_cast<std::size_t>(i)], j,
                                balls[static_cast<std::size_t>(j)], now);
    }

    std::span<std::int32_t const> refresh(std::vector<Ball<Real>> const& balls, std::int32_t ball,
                                          Real now) {
        shells_.renew(ball, balls[static_cast<std::size_t>(ball)], now);
        Cell const cell = lattice_.cell_at(shells_.centre(ball));
        if (cell != bins_.cell_of(ball)) {
            bins_.remove(ball);
            bins_.insert(ball, cell);
        }
        BallBuffer const& fresh = near(ball);
        tell_others(ball, fresh);
        write(ball, fresh);
        added_.template pad<lane_count>(ball);
        return {added_.begin(), added_.size()};
    }

    /// Hints to the memory: a ball's own entries, and what follows `candidates` and `refresh`.
    void fetch(std::int32_t ball) const {
        for (std::size_t place = 0; place < width_; place += line_balls)
            prefetch(row(ball) + place);
        shells_.fetch(ball);
        bins_.fetch(ball);
    }
    void fetch_candidates(std::vector<Ball<Real>> const& balls, std::int32_t ball, Real) const {
        for_each_in_first_line(ball, [&](std::int32_t other) { prefetch(balls.data() + other); });
    }
    /// The centres that `refresh` will compare, unless the new one lies in another cell.
    void fetch_fresh_records(std::vector<Ball<Real>> const&, std::int32_t ball) {
        found_.clear();
        bins_.collect_around(bins_.cell_of(ball), found_);
        for (std::int32_t const other : found_) shells_.fetch(other);
    }
    void fetch_for_refresh(std::vector<Ball<Real>> const& balls, std::int32_t ball) const {
        bins_.fetch_around(bins_.cell_of(ball));
        for_each_in_first_line(ball, [&](std::int32_t other) {
            prefetch(balls.data() + other);
            prefetch(row(other));
            shells_.fetch(other);
        });
    }

    /// The balls of a list, padding among them, but for the few lists that have a second line.
    template <class Visit> void for_each_in_first_line(std::int32_t ball, Visit&& visit) const {
        for (std::size_t k = 0; k < line_balls; ++k) visit(row(ball)[k]);
    }

    std::size_t bytes() const {
        return bins_.bytes() + shells_.bytes() + list_.capacity() * sizeof(Line) + found_.bytes() +
               near_.bytes() + added_.bytes();
    }

private:
    /// Sixteen balls of a list: a cache line.
    static constexpr std::size_t line_balls = 16;
    struct alignas(64) Line : std::array<std::int32_t, line_balls> {};

    using Balls = typename Shells<Real, Container>::Balls;
    static Balls load(std::int32_t const* balls) {
        Balls loaded;
        std::memcpy(&loaded, balls, sizeof loaded);
        return loaded;
    }

    static constexpr double balls_per_cell = 0.7;
    static constexpr int periodic_min = 4; // with 3, a ball would be found through two images

    NeighbourList(System const& system, Container const& cube, Shell const& shell)
        : shells_(system, cube, shell),
          lattice_(system, cube, shell.reach, balls_per_cell, periodic_min),
          bins_(Container::boundary, lattice_.per_side, static_cast<std::size_t>(system.count)) {
        widen(line_balls);
    }

    std::int32_t* row(std::int32_t ball) {
        return list_.front().data() + static_cast<std::size_t>(ball) * width_;
    }
    std::int32_t const* row(std::int32_t ball) const {
        return list_.front().data() + static_cast<std::size_t>(ball) * width_;
    }

    /// The balls whose shells are so near that the balls might touch, in whole lines. Which of two
    /// balls is asked makes no difference, so that lists are mutual.
    BallBuffer const& near(std::int32_t ball) {
        found_.clear();
        bins_.collect_around(bins_.cell_of(ball), found_);
        found_.template pad<lane_count>(ball);
        near_.clear();
        std::int32_t* end = near_.room(found_.size());
        for (std::size_t first = 0; first < found_.size(); first += lane_count) {
            std::int32_t const* const some = found_.begin() + first;
            Balls const near = shells_.near(ball, some) & (load(some) != ball);
            end = write_chosen(some, bits_of(near), end);
        }
        near_.grow_to(end);
        near_.template pad<line_balls>(ball);
        return near_;
    }

    /// Brings the others' lists up to date with a ball's new list. Most balls were near before and
    /// are told nothing.
    void tell_others(std::int32_t ball, BallBuffer const& fresh) {
        std::span<std::int32_t const> const old = candidates(ball);
        for_each_missing(ball, old, {fresh.begin(), fresh.size()}, [&](std::int32_t other) {
            std::size_t const place = place_in(other, ball);
            std::size_t const last = place_in(other, other) - 1;
            row(other)[place] = row(other)[last];
            row(other)[last] = other;
        });
        // Adding may widen the rows, so the old one is read first.
        added_.clear();
        std::int32_t* end = added_.room(fresh.size());
        for_each_missing(ball, {fresh.begin(), fresh.size()}, old,
                         [&](std::int32_t other) { *end++ = other; });
        added_.grow_to(end);
        for (std::int32_t const other : added_) {
            std::size_t const place = place_in(other, other);
            if (place == width_) widen(width_ + line_balls);
            row(other)[place] = ball;
        }
    }

    /// Calls visit(other) for the balls of one list that are not in a second; both in whole lines,
    /// padded with the ball that they belong to.
    template <class Visit>
    static void for_each_missing(std::int32_t ball, std::span<std::int32_t const> list,
                                 std::span<std::int32_t const> second, Visit&& visit) {
        for (std::size_t first = 0; first < list.size(); first += lane_count) {
            Balls const some = load(list.data() + first);
            Balls known = some == ball;
            for (std::size_t k = 0; k < second.size(); k += line_balls)
                for (std::size_t in_line = 0; in_line < line_balls; ++in_line)
                    known |= some == second[k + in_line];
            for_each_lane(~known, [&](std::size_t lane) { visit(list[first + lane]); });
        }
    }

    /// Where a number first stands in a ball's row: the ball itself is what follows the list.
    std::size_t place_in(std::int32_t ball, std::int32_t number) const {
        for (std::size_t first = 0; first < width_; first += lane_count) {
            std::uint32_t const here = bits_of(load(row(ball) + first) == number);
            if (here != 0) return first + static_cast<std::size_t>(__builtin_ctz(here));
        }
        return width_;
    }

    void write(std::int32_t ball, BallBuffer const& list) {
        if (list.size() > width_) widen(list.size());
        std::fill(std::copy(list.begin(), list.end(), row(ball)), row(ball) + width_, ball);
    }

    /// Room for longer lists, for all balls: what follows a list is padding, the ball itself.
    void widen(std::size_t width) {
        auto wider = large_vector<Line>(shells_.size() * width / line_balls);
        for (std::size_t i = 0; i < shells_.size(); ++i) {
            std::int32_t* const to = wider.front().data() + i * width;
            std::fill_n(to, width, static_cast<std::int32_t>(i));
            if (!list_.empty()) std::copy_n(row(static_cast<std::int32_t>(i)), width_, to);
        }
        list_ = std::move(wider);
        width_ = width;
    }

    Shells<Real, Container> shells_;
    CellLattice<Real> lattice_;
    CellBins<7> bins_;
    std::vector<Line> list_; // one row of width_ balls each
    std::size_t width_ = 0;
    BallBuffer found_, near_, added_; // reused
};

} // namespace clack
