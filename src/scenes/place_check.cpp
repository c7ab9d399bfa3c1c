#include "scenes/place_check.hpp"

#include "scenes/limits.hpp"
#include "scenes/near_places.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace clack {

namespace {

/// Comparisons per ball after which a start that is known to be wrong is looked at no further; one
/// without overlap needs fewer than 40, one with all balls in one place would take n^2.
constexpr std::int64_t patience = 100;

/// Places are rounded, and so is the sum that compares them.
double rounding(System const& system) {
    return 4 * std::numeric_limits<double>::epsilon() * system.side;
}

struct Overlap {
    double depth = 0; // diameter - distance  [length]
    Eigen::Index first = 0, second = 0;
};

Overlap deepest_overlap(System const& system, Eigen::Matrix3Xd const& places) {
    NearPlaces near(system, system.diameter, places.cols());
    Overlap deepest;
    std::int64_t comparisons_left = patience * places.cols();
    for (Eigen::Index ball = 0; ball < places.cols(); ++ball) {
        near.visit_near(places.col(ball), [&](std::int32_t other) {
            double const distance = std::sqrt(
                squared_length(separation_of(system, places.col(other), places.col(ball))));
            double const depth = system.diameter - distance;
            if (depth > deepest.depth) deepest = {depth, other, ball};
            bool const enough = --comparisons_left < 0 && deepest.depth > rounding(system);
            return enough ? NearPlaces::Visit::stop : NearPlaces::Visit::go_on;
        });
        near.add(places.col(ball));
    }
    return deepest;
}

/// The first coordinate that is not finite or lies outside what the centres can reach.
std::optional<Misplaced> ball_outside(System const& system, Eigen::Matrix3Xd const& places) {
    bool const walls = system.boundary == Boundary::walls;
    double const low = walls ? system.diameter / 2 : -furthest_image * system.side;
    double const high = walls ? system.side - system.diameter / 2 : furthest_image * system.side;
    for (Eigen::Index ball = 0; ball < places.cols(); ++ball) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            double const x = places(axis, ball);
            if (x >= low - rounding(system) && x <= high + rounding(system)) continue;
            auto const name = fmt::format("ball {} has {} = {}", ball, "xyz"[axis], x);
            if (!std::isfinite(x))
                return Misplaced{ball, name + ": must be a finite number; correct it"};
            return Misplaced{ball,
                             fmt::format("{}: {}must lie in [{:.10g}, {:.10g}]{}; move it{}", name,
                                         walls ? "sticks out of the cube, the centre " : "", low,
                                         high, walls ? ", half a diameter from the walls" : "",
                                         walls ? " or enlarge side" : " nearer")};
        }
    }
    return std::nullopt;
}

} // namespace

void wrap_places(System const& system, Eigen::Matrix3Xd& places) {
    if (system.boundary != Boundary::periodic) return;
    for (double& x : places.reshaped()) {
        if (x >= 0 && x < system.side) continue;
        x -= system.side * std::floor(x / system.side);
        if (!(x >= 0 && x < system.side)) x = 0; // a place just below 0 rounds up to the side
    }
}

std::optional<Misplaced> misplaced_ball(System const& system, Eigen::Matrix3Xd const& places) {
    if (auto outside = ball_outside(system, places)) return outside;
    Eigen::Matrix3Xd inside = places;
    wrap_places(system, inside);
    auto const [depth, first, second] = deepest_overlap(system, inside);
    if (depth <= rounding(system)) return std::nullopt;
    return Misplaced{second,
                     fmt::format("balls {} and {} overlap by {:.3g} diameters: centres must be at "
                                 "least diameter = {:.10g} apart; move them or make them smaller",
                                 first, second, depth / system.diameter, system.diameter)};
}

} // namespace clack
