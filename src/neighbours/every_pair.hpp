#pragma once
// The report's search: every ball is checked against all others, O(n).

#include "neighbours/neighbour_search.hpp"
#include "prediction/lanes.hpp"
#include "state/container.hpp"
#include "state/system.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace clack {

/// All balls are candidates of each. Between walls that holds for ever; in a periodic cube the
/// image that a prediction looked at stops being the nearest when the two balls have moved far
/// enough.
template <class Real, class Container> class EveryPair {
public:
    EveryPair(System const& system, Container const&)
        : count_(system.count), everyone_(padded(static_cast<std::size_t>(system.count))),
          reach_(image_reach(system)) {
        std::iota(everyone_.begin(), everyone_.end(), 0);
    }

    void rebuild(std::vector<Ball<Real>> const&, Real) {}
    void settle(std::vector<Ball<Real>> const&, std::int32_t) {}

    std::span<std::int32_t const> candidates(std::int32_t ball) {
        std::fill(everyone_.begin() + count_, everyone_.end(), ball);
        return everyone_;
    }

    Real expiry(std::vector<Ball<Real>> const& balls, std::int32_t ball, Real now) const {
        if constexpr (Container::boundary == Boundary::walls) return infinity<Real>;
        auto const& velocity = balls[static_cast<std::size_t>(ball)].velocity;
        Real const fastest = velocity.cwiseAbs().maxCoeff();
        return fastest > 0 ? now + reach_ / fastest : infinity<Real>;
    }

    std::span<std::int32_t const> refresh(std::vector<Ball<Real>> const&, std::int32_t ball, Real) {
        return candidates(ball);
    }

    std::size_t bytes() const { return everyone_.capacity() * sizeof(std::int32_t); }

    static std::size_t padded(std::size_t count) {
        return (count + lane_count - 1) / lane_count * lane_count;
    }

private:
    /// How far a ball may move along an axis before its images are looked at again. From one look
    /// to the next two balls shift by three such reaches at most (one has as much as two behind it
    /// unseen), and an image that was not looked at is this far from contact:
    ///   half a side less a diameter, or, in a box below four diameters where all images next to
    ///   the nearest are looked at too, one and a half sides less a diameter.
    static Real image_reach(System const& system) {
        double const sides = touches_through_several_images(system) ? 1.5 : 0.5;
        double const slack = 0.99; // for rounding
        return static_cast<Real>(slack * (sides * system.side - system.diameter) / 3);
    }

    std::ptrdiff_t count_;
    std::vector<std::int32_t> everyone_; // and padding
    Real reach_;
};

} // namespace clack
