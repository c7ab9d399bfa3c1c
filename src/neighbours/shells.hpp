#pragma once
// The shell that each ball is in as long as its list holds.

#include "neighbours/shell.hpp"
#include "prediction/lanes.hpp"
#include "state/ball.hpp"
#include "state/huge_pages.hpp"
#include "state/prefetch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <vector>

namespace clack {

/// Where the shells of all balls have their centres, when the balls leave them, and which of them
/// are near each other. Centres are in single precision, in diameters: what a place is rounded to
/// is the centre.
template <class Real, class Container> class Shells {
public:
    /// As many balls as lanes, or all bits of those that a condition holds for.
    using Balls = LaneIntegers<float>;

    Shells(System const& system, Container const& cube, Shell const& shell)
        : cube_(cube), radius2_(shell.radius * shell.radius), ahead_(shell.ahead),
          wide_diameter_(system.diameter), wide_side_(system.side),
          wide_inverse_side_(1 / system.side),
          reach_(static_cast<float>(shell.reach / system.diameter)),
          diameter_(static_cast<Real>(system.diameter)), per_diameter_(1 / diameter_),
          side_(static_cast<float>(system.side / system.diameter)), inverse_side_(1 / side_),
          centre_(large_vector<Centre>(static_cast<std::size_t>(system.count))) {}

    /// Puts a shell about a place.
    void put(std::int32_t ball, Vector3<Real> place) {
        cube_.wrap(place);
        Centre centre{};
        for (std::size_t d = 0; d < 3; ++d)
            centre[d] = static_cast<float>(place[static_cast<int>(d)] * per_diameter_);
        at(ball) = centre;
    }
    /// Puts a new shell a little ahead of its ball. A direction is as sure for the slowest ball as
    /// for any.
    void renew(std::int32_t ball, Ball<Real> const& record, Real now) {
        Numbers const v = velocity_in_double(record);
        double const speed = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        Vector3<Real> place = record.position(now);
        if (speed > 0)
            for (int d = 0; d < 3; ++d) place[d] += static_cast<Real>(v[d] / speed * ahead_);
        put(ball, place);
    }

    Vector3<Real> centre(std::int32_t ball) const {
        Vector3<Real> place;
        for (std::size_t d = 0; d < 3; ++d)
            place[static_cast<int>(d)] = static_cast<Real>(at(ball)[d]) * diameter_;
        return place;
    }

    /// When a ball leaves its shell: the later root of |x - centre| = radius.
    Real expiry(std::int32_t ball, Ball<Real> const& record, Real now) const {
        Numbers const v = velocity_in_double(record);
        Numbers const r =
            from_centre(ball, point_in_double(record) + v * static_cast<double>(now - record.time));
        auto const dot = [](Numbers const& x) { return x[0] + x[1] + x[2]; };
        return now + static_cast<Real>(time_inside(dot(v * v), dot(r * v), dot(r * r)));
    }
    /// The same side by side for two balls that were written at `now`: 1.04 times as fast.
    std::array<Real, 2> expiries(std::int32_t i, Ball<Real> const& one, std::int32_t j,
                                 Ball<Real> const& other, Real now) const {
        Numbers const v_i = velocity_in_double(one), v_j = velocity_in_double(other);
        Numbers const r_i = from_centre(i, point_in_double(one));
        Numbers const r_j = from_centre(j, point_in_double(other));
        Twos const inside =
            time_inside(sums_of_three(v_i * v_i, v_j * v_j), sums_of_three(r_i * v_i, r_j * v_j),
                        sums_of_three(r_i * r_i, r_j * r_j));
        return {now + static_cast<Real>(inside[0]), now + static_cast<Real>(inside[1])};
    }

    /// Which of the balls, as many as lanes, have shells so near a ball's that they might touch it.
    /// Which of two balls is asked makes no difference.
    [[gnu::always_inline]] Balls near(std::int32_t ball, std::int32_t const* others) const {
        Centre const own = at(ball);
        auto const other = turned<float>([&](int k) {
            Fours<float> loaded;
            std::memcpy(&loaded, &at(others[k]), sizeof loaded);
            return loaded;
        });
        Distances const x = apart(other.first - own[0]), y = apart(other.second - own[1]),
                        z = apart(other.third - own[2]);
        return x * x + y * y + z * z < reach_ * reach_;
    }

    void fetch(std::int32_t ball) const { prefetch(&at(ball)); }

    std::size_t size() const { return centre_.size(); }
    std::size_t bytes() const { return centre_.capacity() * sizeof(Centre); }

private:
    using Centre = std::array<float, 4>; // the fourth number makes it one load
    using Numbers = Fours<double>;       // an index needs no more than double
    using Distances = Lanes<float>;

    Centre& at(std::int32_t ball) { return centre_[static_cast<std::size_t>(ball)]; }
    Centre const& at(std::int32_t ball) const { return centre_[static_cast<std::size_t>(ball)]; }

    /// A place, seen from the centre of a ball's shell.
    Numbers from_centre(std::int32_t ball, Numbers place) const {
        place -= in_double(at(ball)) * wide_diameter_;
        if constexpr (Container::boundary == Boundary::periodic)
            place -= nearest_integer<Numbers, double>(place * wide_inverse_side_) * wide_side_;
        return place;
    }

    /// How long a ball stays in its shell, from v.v, r.v and r.r. What the difference loses is a
    /// rounding of the shell's radius, and `reach` has room for more; to choose a formula by the
    /// sign of r.v would be a branch that cannot be foretold.
    template <class Number> Number time_inside(Number v2, Number rv, Number r2) const {
        Number const zero{}, never = zero + infinity<double>, inside = radius2_ - r2;
        if constexpr (std::is_same_v<Number, double>) { // nearly always true
            if (!(v2 > 0)) return never;
            if (!(inside > 0)) return zero;
        }
        Number const way = square_root(rv * rv + v2 * inside) - rv;
        return select(inside > zero, later(way, select(v2 > zero, zero, never)) / v2, zero);
    }

    /// One component of the way between two centres, through the nearest image.
    Distances apart(Distances distance) const {
        if constexpr (Container::boundary == Boundary::periodic)
            distance -= nearest_integer<Distances, float>(distance * inverse_side_) * side_;
        return distance;
    }

    Container cube_;
    double radius2_, ahead_; // the radius squared, the centre's way ahead of its ball
    double wide_diameter_, wide_side_, wide_inverse_side_;
    float reach_; // between the centres of two shells whose balls might touch  [diameters]
    Real diameter_, per_diameter_;
    float side_, inverse_side_; // of the cube  [diameters]
    std::vector<Centre> centre_;
};

} // namespace clack
