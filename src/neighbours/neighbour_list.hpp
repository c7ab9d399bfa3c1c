#pragma once
// Each ball's own list of balls near it, good until it leaves the shell around the list's centre.

#include "neighbours/cell_grid.hpp"

#include <algorithm>
#include <cmath>

namespace clack {

/// Two balls are in each other's lists when the centres of their shells lie within a diameter and
/// two shell radii: while both stay inside their shells, no other pair can touch. A ball that
/// leaves its shell gets a new list about where it is, alone.
template <class Real, class Container> class NeighbourList {
public:
    NeighbourList(System const& system, Container const& cube)
        : cube_(cube), radius_(static_cast<Real>(shell_radius(system))),
          reach_(static_cast<Real>(reach(system))),
          lattice_(system, cube, reach(system), balls_per_cell),
          bins_(Container::boundary, lattice_.per_side, static_cast<std::size_t>(system.count)),
          centre_(static_cast<std::size_t>(system.count)),
          length_(static_cast<std::size_t>(system.count)) {
        widen(first_width);
    }

    /// Whether a periodic cube is wide enough for the nearest image to be the only one in reach.
    static bool fits(System const& system) {
        return system.boundary == Boundary::walls || system.side > 4.1 * reach(system);
    }

    void rebuild(std::vector<Ball<Real>> const& balls, Real now) {
        bins_.clear();
        std::fill(length_.begin(), length_.end(), 0);
        for (std::size_t i = 0; i < balls.size(); ++i) {
            centre_[i] = balls[i].position(now);
            cube_.wrap(centre_[i]);
            auto const ball = static_cast<std::int32_t>(i);
            std::fill_n(row(ball), width_, ball);
            // Lists are mutual, so each ball meets only those that came before it.
            connect(ball);
            bins_.insert(ball, lattice_.cell_at(centre_[i]));
        }
    }

    std::span<std::int32_t const> candidates(std::int32_t ball) const {
        auto const length = static_cast<std::size_t>(length_[static_cast<std::size_t>(ball)]);
        return {row(ball), EveryPair<Real, Container>::padded(length)};
    }

    /// When the ball leaves its shell: the later root of |x - centre| = radius, formed without
    /// cancellation.
    Real expiry(std::vector<Ball<Real>> const& balls, std::int32_t ball, Real now) const {
        Ball<Real> const& record = balls[static_cast<std::size_t>(ball)];
        Vector3<Real> const out = from_centre(record.position(now), ball);
        Vector3<Real> const& v = record.velocity;
        Real const a = dot<Real>(v, v), b = dot<Real>(out, v);
        Real const inside = radius_ * radius_ - dot<Real>(out, out);
        if (!(a > 0)) return infinity<Real>;
        if (!(inside > 0)) return now;
        using std::sqrt;
        Real const root = sqrt(b * b + a * inside);
        return now + (b > 0 ? inside / (b + root) : (root - b) / a);
    }

    std::span<std::int32_t const> refresh(std::vector<Ball<Real>> const& balls, std::int32_t ball,
                                          Real now) {
        disconnect(ball);
        bins_.remove(ball);
        Vector3<Real>& centre = centre_[static_cast<std::size_t>(ball)];
        centre = balls[static_cast<std::size_t>(ball)].position(now);
        cube_.wrap(centre);
        connect(ball);
        bins_.insert(ball, lattice_.cell_at(centre));
        return candidates(ball);
    }

    std::size_t bytes() const {
        return bins_.bytes() + centre_.capacity() * sizeof(Vector3<Real>) +
               (length_.capacity() + list_.capacity()) * sizeof(std::int32_t) + found_.bytes();
    }

private:
    static constexpr double balls_per_cell = 0.7;
    static constexpr std::size_t first_width = 16;

    /// Measured: thick shells make long lists, thin ones many rebuilds; the flat best is a third of
    /// a diameter in the fluid and less where a crystal leaves balls no way out of their cages.
    static double shell_radius(System const& system) {
        double const best = 0.32 - 0.6 * (system.packing_fraction() - 0.5);
        return system.diameter * std::clamp(best, 0.18, 0.32);
    }
    static double reach(System const& system) {
        double const rounding =
            1024 * static_cast<double>(unit_roundoff<Real>) * (system.diameter + system.side);
        return system.diameter + 2 * shell_radius(system) + rounding;
    }

    std::int32_t* row(std::int32_t ball) {
        return list_.data() + static_cast<std::size_t>(ball) * width_;
    }
    std::int32_t const* row(std::int32_t ball) const {
        return list_.data() + static_cast<std::size_t>(ball) * width_;
    }

    Vector3<Real> from_centre(Vector3<Real> place, std::int32_t ball) const {
        place -= centre_[static_cast<std::size_t>(ball)];
        if constexpr (Container::boundary == Boundary::periodic)
            for (int d = 0; d < 3; ++d) place[d] -= cube_.image(place[d]) * cube_.side;
        return place;
    }

    void connect(std::int32_t ball) {
        Vector3<Real> const centre = centre_[static_cast<std::size_t>(ball)];
        found_.clear();
        bins_.collect_block(lattice_.cell_at(centre), {-1, -1, -1}, {1, 1, 1}, found_);
        for (std::int32_t const other : found_) {
            Vector3<Real> const apart = from_centre(centre, other);
            if (dot<Real>(apart, apart) >= reach_ * reach_) continue;
            append(ball, other);
            append(other, ball);
        }
    }

    void disconnect(std::int32_t ball) {
        auto& length = length_[static_cast<std::size_t>(ball)];
        while (length > 0) {
            std::int32_t const other = row(ball)[--length];
            row(ball)[length] = ball;
            auto& other_length = length_[static_cast<std::size_t>(other)];
            std::int32_t* const begin = row(other);
            std::int32_t* const end = begin + other_length--;
            *std::find(begin, end, ball) = *(end - 1);
            *(end - 1) = other;
        }
    }

    void append(std::int32_t ball, std::int32_t other) {
        auto& length = length_[static_cast<std::size_t>(ball)];
        if (static_cast<std::size_t>(length) == width_) widen(width_ + lane_count);
        row(ball)[length++] = other;
    }

    /// Room for longer lists, for all balls: what follows a list is padding, the ball itself.
    void widen(std::size_t width) {
        std::vector<std::int32_t> wider(length_.size() * width);
        for (std::size_t i = 0; i < length_.size(); ++i) {
            auto const to = wider.begin() + static_cast<std::ptrdiff_t>(i * width);
            std::fill_n(to, width, static_cast<std::int32_t>(i));
            auto const from = list_.begin() + static_cast<std::ptrdiff_t>(i * width_);
            std::copy_n(from, std::min(width_, list_.size()), to);
        }
        list_.swap(wider);
        width_ = width;
    }

    Container cube_;
    Real radius_; // of a shell
    Real reach_;  // between the centres of two shells whose balls might touch
    CellLattice<Real> lattice_;
    CellBins bins_;
    std::vector<Vector3<Real>> centre_;
    std::vector<std::int32_t> length_;
    std::vector<std::int32_t> list_; // one row of width_ a ball
    std::size_t width_ = 0;
    BallBuffer found_; // reused
};

} // namespace clack
