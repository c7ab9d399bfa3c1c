#pragma once
// Self-diffusion: state points, one measurement by two routes, and what it should give.

#include "reference/enskog.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/self_motion.hpp"
#include "validation/statistics/estimate.hpp"

#include <fmt/format.h>

namespace clack::validation::self_diffusion {

/// Where, and between which times the mean square displacement is taken to be straight.
struct StatePoint {
    PeriodicFluid fluid;
    double from, to;   // mean free times
    double production; // the same, of one replicate
    int replicates = 8;

    std::string text() const {
        return fmt::format("{} from={} to={} production={}", fluid.text(), from, to, production);
    }
};

constexpr double dilute = 0.002;       // packing fraction where Enskog's theory is exact to 0.3 %
constexpr double of_sizes = 0.2617994; // number density 0.5: where a ball feels the box most

/// One dilute gas, the fluid up to freezing, and one density at several numbers of balls.
inline std::vector<StatePoint> state_points(Profile const profile) {
    double const longer = profile == Profile::quick ? 1 : 16;
    std::vector<StatePoint> points{{{dilute, 1000}, 10, 20, 250 * longer, 16}};
    for (double const eta : {0.1, 0.2, 0.3, 0.4})
        points.push_back({{eta, 500}, 20, 40, 800 * longer});
    points.push_back({{0.45, 500}, 60, 120, 1200 * longer});
    points.push_back({{0.49, 500}, 60, 120, 2500 * longer});
    points.push_back({{of_sizes, 108}, 40, 80, 5000 * longer});
    points.push_back({{of_sizes, 256}, 40, 80, 2200 * longer});
    points.push_back({{of_sizes, 864}, 40, 80, 800 * longer});
    return points;
}

/// By the mean square displacement (Einstein) and by the velocity autocorrelation (Green, Kubo).
enum Value : std::size_t { einstein, green_kubo };

/// Integral of (t - s) C(s) from 0 to t by trapezoids of width h with the first correction of Euler
/// and Maclaurin, for which the slope at 0 is known exactly.
inline double twice_integrated(SelfCorrelation const& correlation, std::size_t const lag,
                               double const h, double const slope) {
    double const t = static_cast<double>(lag) * h;
    double const start = correlation.velocity_autocorrelation(0);
    double sum = t * start / 2;
    for (std::size_t k = 1; k < lag; ++k)
        sum += (t - static_cast<double>(k) * h) * correlation.velocity_autocorrelation(k);
    double const end = correlation.velocity_autocorrelation(lag);
    return sum * h - h * h / 12 * (start - end - t * slope * start);
}

/// Both routes give the mean of the same function, D(t) = integral of C/3 up to t, between the two
/// times: they must agree whether or not D(t) has come to rest.
inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    Watch const watch{.interval = 0.2,
                      .longest = point.to,
                      .origin_spacing = point.to / 20,
                      .production = point.production};
    SelfCorrelation const seen = watch_balls(point.fluid, watch, seed, make);
    double const h = watch.interval / point.fluid.collision_rate();
    auto const first = static_cast<std::size_t>(std::lround(point.from / watch.interval));
    std::size_t const last = seen.lag_max();
    double const span = static_cast<double>(last - first) * h;
    double const slope = initial_slope(point.fluid);
    return {(seen.mean_square_displacement(last) - seen.mean_square_displacement(first)) /
                (6 * span),
            (twice_integrated(seen, last, h, slope) - twice_integrated(seen, first, h, slope)) /
                (3 * span)};
}

/// What the box takes off, with Enskog's viscosity and the self-diffusion found.
inline double deficit(PeriodicFluid const& fluid, std::vector<Measurement> const& seen) {
    return reference::periodic_diffusion_deficit(
        reference::Enskog(fluid.packing_fraction).shear_viscosity, fluid.number_density(),
        mean_of(seen, einstein).value, fluid.side());
}

/// Self-diffusion in units of Enskog's, for infinitely many balls.
inline Estimate extrapolated(PeriodicFluid const& fluid, std::vector<Measurement> const& seen) {
    double const unit = reference::Enskog(fluid.packing_fraction).self_diffusion;
    Estimate found = mean_of(seen, einstein);
    found.value = (found.value + deficit(fluid, seen)) / unit;
    found.error /= unit;
    return found;
}

/// Slope of D against 1/side through several sizes, over the expected one; each replicate gives
/// one.
inline Estimate size_slope(std::vector<StatePoint> const& points,
                           std::vector<std::vector<Measurement>> const& all) {
    std::vector<double> slopes;
    for (std::size_t replicate = 0; replicate < all.front().size(); ++replicate) {
        std::vector<double> deficits, found;
        for (std::size_t p = 0; p < points.size(); ++p) {
            deficits.push_back(deficit(points[p].fluid, all[p]));
            found.push_back(all[p][replicate][einstein]);
        }
        slopes.push_back(-line_through(deficits, found).slope);
    }
    return mean_of(slopes);
}

/// Margins as parts: of one route for the other, of Enskog's value, of the slope with 1/side.
constexpr double route_margin = 0.02, slope_margin = 0.25;
constexpr double dilute_margin = (reference::self_diffusion_all_orders - 1) / 2;

/// The two routes, everywhere, and Enskog's value where it is exact.
inline void enter(Ledger& ledger, StatePoint const& point, std::vector<Measurement> const& seen) {
    std::vector<std::string> const state{fmt::format("{:.3f}", point.fluid.packing_fraction),
                                         cell(point.fluid.count)};
    auto const ratio = [](Measurement const& m) { return m[green_kubo] / m[einstein]; };
    ledger.compare(state, {"route_ratio", "$D_{\\text{GK}}/D_{\\text{E}}$"},
                   {{}, mean_of(seen, ratio), 1, 0, route_margin});
    Estimate const found = extrapolated(point.fluid, seen);
    double const unit = reference::Enskog(point.fluid.packing_fraction).self_diffusion;
    if (point.fluid.packing_fraction == dilute) {
        ledger.compare(state, {"over_enskog", "$D/D_{\\text{Enskog}}$"},
                       {{}, found, 1, 0, dilute_margin});
        return;
    }
    Estimate raw = mean_of(seen, einstein);
    raw = {raw.value / unit, raw.error / unit, raw.degrees_of_freedom};
    double const speedy = reference::speedy_self_diffusion(point.fluid.number_density()) / unit;
    ledger.guide(state, {"over_enskog_in_box", "$D(n)/D_{\\text{Enskog}}$, Speedy"},
                 {{}, raw, speedy});
}

} // namespace clack::validation::self_diffusion
