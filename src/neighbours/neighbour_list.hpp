#pragma once
// Each ball's own list of balls near it, good until it leaves the shell around the list's centre.

#include "neighbours/cell_grid.hpp"
#include "prediction/sixteen.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace clack {

/// Two balls are in each other's lists when the centres of their shells lie within a diameter and
/// two shell radii: while both stay inside their shells, no other pair can touch. A ball that
/// leaves its shell gets a new list about where it is, alone.
template <class Real, class Container> class NeighbourList {
public:
    NeighbourList(System const& system, Container const& cube)
        : cube_(cube), radius_(static_cast<Real>(shell_radius(system))),
          reach_(static_cast<float>(reach(system) / system.diameter)),
          diameter_(static_cast<Real>(system.diameter)), per_diameter_(1 / diameter_),
          side_(static_cast<float>(system.side / system.diameter)), inverse_side_(1 / side_),
          lattice_(system, cube, reach(system), balls_per_cell),
          bins_(Container::boundary, lattice_.per_side, static_cast<std::size_t>(system.count)),
          centre_(large_vector<Centre>(static_cast<std::size_t>(system.count))),
          length_(large_vector<std::int32_t>(centre_.size())) {
        widen(first_width);
    }

    /// Whether a periodic cube is wide enough for the nearest image to be the only one in reach.
    static bool fits(System const& system) {
        return system.boundary == Boundary::walls || system.side > 4.1 * reach(system);
    }

    /// Where lists fit, those on them are within a quarter of a side.
    static constexpr bool nearest_image_is_clear() { return true; }

    void rebuild(std::vector<Ball<Real>> const& balls, Real now) {
        bins_.clear();
        std::fill(length_.begin(), length_.end(), 0);
        for (std::size_t i = 0; i < balls.size(); ++i) {
            centre_[i] = centre_at(balls[i].position(now));
            auto const ball = static_cast<std::int32_t>(i);
            std::fill_n(row(ball), width_, ball);
            // Lists are mutual, so each ball meets only those that came before it.
            connect(ball);
            bins_.insert(ball, lattice_.cell_at(place_of(centre_[i])));
        }
    }

    std::span<std::int32_t const> candidates(std::int32_t ball) const {
        std::int32_t const* const list = row(ball);
        std::size_t end = screen_lanes;
        while (end < width_ && list[end - 1] != ball && list[end] != ball) end += screen_lanes;
        return {list, end};
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
        Centre& centre = centre_[static_cast<std::size_t>(ball)];
        centre = centre_at(balls[static_cast<std::size_t>(ball)].position(now));
        connect(ball);
        bins_.insert(ball, lattice_.cell_at(place_of(centre)));
        return candidates(ball);
    }

    /// Hints to the memory: a ball's own entries, and what its refresh will touch.
    void fetch(std::int32_t ball) const {
        __builtin_prefetch(row(ball));
        __builtin_prefetch(centre_.data() + ball);
        bins_.fetch(ball);
    }
    void fetch_for_refresh(std::int32_t ball) const {
        for (std::int32_t const other : candidates(ball)) {
            __builtin_prefetch(row(other), 1);
            __builtin_prefetch(length_.data() + other, 1);
        }
        bins_.fetch_around(ball);
    }

    std::size_t bytes() const {
        return bins_.bytes() + centre_.capacity() * sizeof(Centre) +
               length_.capacity() * sizeof(std::int32_t) + list_.capacity() * sizeof(Line) +
               found_.bytes();
    }

private:
    /// In single precision, in diameters: what it is rounded to is the centre. The fourth number
    /// makes it one load.
    using Centre = std::array<float, 4>;

    /// Sixteen balls of a list: a cache line.
    struct alignas(64) Line : std::array<std::int32_t, screen_lanes> {};

    static constexpr double balls_per_cell = 0.7;
    static constexpr std::size_t first_width = screen_lanes;

    /// Thick shells make long lists, thin ones many rebuilds. Measured: best where a list just
    /// about fills the sixteen lanes of one look.
    static double shell_radius(System const& system) {
        constexpr double listed = 14; // balls, on average
        double const reach = std::cbrt(listed * 3 / (4 * std::numbers::pi * density(system)));
        return system.diameter * std::clamp((reach - 1) / 2, 0.15, 0.6);
    }
    static double density(System const& system) { // per cubic diameter
        return system.packing_fraction() * 6 / std::numbers::pi;
    }
    static double reach(System const& system) {
        // Of the float that the centres are compared in.
        double const rounding = 64 * 0x1p-24 * (system.diameter + system.side);
        return system.diameter + 2 * shell_radius(system) + rounding;
    }

    std::int32_t* row(std::int32_t ball) {
        return list_.front().data() + static_cast<std::size_t>(ball) * width_;
    }
    std::int32_t const* row(std::int32_t ball) const {
        return list_.front().data() + static_cast<std::size_t>(ball) * width_;
    }

    Centre centre_at(Vector3<Real> place) const {
        cube_.wrap(place);
        Centre centre{};
        for (std::size_t d = 0; d < 3; ++d)
            centre[d] = static_cast<float>(place[static_cast<int>(d)] * per_diameter_);
        return centre;
    }
    Vector3<Real> place_of(Centre const& centre) const {
        Vector3<Real> place;
        for (std::size_t d = 0; d < 3; ++d)
            place[static_cast<int>(d)] = static_cast<Real>(centre[d]) * diameter_;
        return place;
    }

    Vector3<Real> from_centre(Vector3<Real> place, std::int32_t ball) const {
        Vector3<Real> const centre = place_of(centre_[static_cast<std::size_t>(ball)]);
        for (int d = 0; d < 3; ++d) {
            place[d] -= centre[d];
            if constexpr (Container::boundary == Boundary::periodic)
                place[d] -= cube_.image(place[d]) * cube_.side;
        }
        return place;
    }

    /// One component of the way between two centres, through the nearest image.
    Floats apart(Floats distance) const {
        if constexpr (Container::boundary == Boundary::periodic)
            distance = distance - nearest_integer<Floats, float>(distance * inverse_side_) * side_;
        return distance;
    }

    void connect(std::int32_t ball) {
        Centre const own = centre_[static_cast<std::size_t>(ball)];
        found_.clear();
        bins_.collect_around(lattice_.cell_at(place_of(own)), found_);
        found_.pad(ball, screen_lanes);
        for (std::size_t first = 0; first < found_.size(); first += screen_lanes) {
            std::int32_t const* const sixteen = found_.begin() + first;
            Quads const other = load_quads<4>(centre_.front().data(), sixteen);
            Floats const x = apart(other.x - own[0]), y = apart(other.y - own[1]),
                         z = apart(other.z - own[2]);
            Integers const near =
                (x * x + y * y + z * z < reach_ * reach_) & (load_sixteen(sixteen) != ball);
            std::int32_t chosen[screen_lanes];
            int count = 0;
            for (int lane = 0; lane < screen_lanes; ++lane) {
                chosen[count] = sixteen[lane];
                count -= near[lane]; // true is -1
            }
            for (int k = 0; k < count; ++k) {
                append(ball, chosen[k]);
                append(chosen[k], ball);
            }
        }
    }

    void disconnect(std::int32_t ball) {
        auto& length = length_[static_cast<std::size_t>(ball)];
        while (length > 0) {
            std::int32_t const other = row(ball)[--length];
            row(ball)[length] = ball;
            std::int32_t* const others = row(other);
            std::int32_t const last = --length_[static_cast<std::size_t>(other)];
            others[place_in(others, ball)] = others[last];
            others[last] = other;
        }
    }

    /// Where a ball stands in a row that holds it once.
    std::int32_t place_in(std::int32_t const* row, std::int32_t ball) const {
        for (std::int32_t first = 0;; first += screen_lanes) {
            Integers const here = load_sixteen(row + first) == ball;
            std::int32_t const place = least_of(here ? lane_numbers() : Integers{} + screen_lanes);
            if (place < screen_lanes) return first + place;
        }
    }

    void append(std::int32_t ball, std::int32_t other) {
        auto& length = length_[static_cast<std::size_t>(ball)];
        if (static_cast<std::size_t>(length) == width_) widen(width_ + screen_lanes);
        row(ball)[length++] = other;
    }

    /// Room for longer lists, for all balls: what follows a list is padding, the ball itself.
    void widen(std::size_t width) {
        auto wider = large_vector<Line>(length_.size() * width / screen_lanes);
        for (std::size_t i = 0; i < length_.size(); ++i) {
            std::int32_t* const to = wider.front().data() + i * width;
            std::fill_n(to, width, static_cast<std::int32_t>(i));
            if (!list_.empty()) std::copy_n(row(static_cast<std::int32_t>(i)), width_, to);
        }
        list_.swap(wider);
        width_ = width;
    }

    Container cube_;
    Real radius_; // of a shell
    float reach_; // between the centres of two shells whose balls might touch  [diameters]
    Real diameter_, per_diameter_;
    float side_, inverse_side_; // of the cube  [diameters]
    CellLattice<Real> lattice_;
    CellBins bins_;
    std::vector<Centre> centre_;
    std::vector<std::int32_t> length_;
    std::vector<Line> list_; // one row of width_ balls each
    std::size_t width_ = 0;
    BallBuffer found_; // reused
};

} // namespace clack
