#pragma once
// How balls forget their velocity: state points, one measurement, and what it should give.

#include "reference/enskog.hpp"
#include "reference/kac_walk.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/self_motion.hpp"
#include "validation/statistics/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace clack::validation::velocity_autocorrelation {

/// What is looked at there.
enum class Part { decay, tail };

struct StatePoint {
    Part part;
    PeriodicFluid fluid;
    double production; // mean free times, of one replicate
    int replicates = 16;

    std::string text() const {
        return fmt::format("{} {} production={}", part == Part::decay ? "decay" : "tail",
                           fluid.text(), production);
    }
    bool is_long() const { return production >= 1000; }
    /// In mean free times. The tail is seen once the ball's own collisions are forgotten, and
    /// before sound has crossed the cube.
    Watch watch() const {
        if (part == Part::decay) return {0.1, 6, 0.5, production};
        return {1, is_long() ? 40.0 : 25.0, 2, production};
    }
};

constexpr double dilute = 0.002; // packing fraction of the gas that Kac's walk describes
constexpr double tail_from = 12; // mean free times
constexpr int walk_count = 3000;

/// The decay in a gas and a fluid; the tail in the densities where it is largest. Its height in a
/// hundredth of <v^2> takes many balls, so that the quick profile looks at one density only.
inline std::vector<StatePoint> state_points(Profile const profile) {
    bool const quick = profile == Profile::quick;
    double const longer = quick ? 1 : 20;
    std::vector<StatePoint> points{{Part::decay, {dilute, 500}, 300 * longer},
                                   {Part::decay, {0.3, 500}, 400 * longer}};
    if (quick) {
        points.push_back({Part::tail, {0.2, 1372}, 300});
    } else {
        for (double const eta : {0.1, 0.2, 0.3}) points.push_back({Part::tail, {eta, 6912}, 2500});
    }
    return points;
}

/// C(t) / C(0), lag by lag.
inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    SelfCorrelation const seen = watch_balls(point.fluid, point.watch(), seed, make);
    Measurement values;
    for (std::size_t lag = 0; lag <= seen.lag_max(); ++lag)
        values.push_back(seen.velocity_autocorrelation(lag) / seen.velocity_autocorrelation(0));
    return values;
}

/// The same of a walk of Kac, every mean free time's tenth.
inline Measurement walk(StatePoint const& point, std::uint64_t const seed) {
    PeriodicFluid const& fluid = point.fluid;
    auto const count = static_cast<double>(fluid.count);
    Eigen::Matrix3Xd const start = make_start(fluid.scene(seed)).velocities;
    // So that the walk, too, has one collision a ball and mean free time.
    double const freedom = 3 * count - 3;
    double const mean_relative_speed =
        4 * std::numbers::inv_sqrtpi * reference::energy_shell_factor(freedom);
    reference::KacWalk kac(start, 1 / ((count - 1) * mean_relative_speed),
                           reference::KacWalk::Momentum::kept, seed + 1);
    Measurement values;
    Watch const watch = point.watch();
    for (int lag = 0; lag <= std::lround(watch.longest / watch.interval); ++lag) {
        kac.advance(lag * watch.interval);
        values.push_back(start.cwiseProduct(kac.velocities()).sum() / start.squaredNorm());
    }
    return values;
}

/// -d ln C / dt at 0 in units of the collision rate, from the first two lags: the quotient of
/// each, extrapolated.
inline double measured_slope(Measurement const& values, double const interval) {
    double const one = std::log(values[1]) / interval, two = std::log(values[2]) / (2 * interval);
    return 2 * one - two;
}

/// What the vortex that a ball has raised gives back to it, in the fluid's box.
inline double tail(PeriodicFluid const& fluid, double const mean_free_times) {
    reference::Enskog const enskog(fluid.packing_fraction);
    double const kinematic = enskog.shear_viscosity / fluid.number_density();
    return reference::long_time_tail_in_box(static_cast<double>(fluid.count), fluid.side(),
                                            enskog.self_diffusion, kinematic,
                                            mean_free_times / fluid.collision_rate());
}

/// Measured tail over the expected one as time goes to infinity: C less Enskog's decay, over the
/// tail, is drawn straight against 1/time from `tail_from` on and read at 0. What comes after the
/// tail falls off faster, and is still a third of it at 25 mean free times.
inline double tail_ratio(StatePoint const& point, Measurement const& values) {
    double const interval = point.watch().interval;
    std::vector<double> inverse_times;
    std::vector<Estimate> ratios; // with errors as those of C, which are even
    for (std::size_t lag = 0; lag < values.size(); ++lag) {
        double const time = static_cast<double>(lag) * interval;
        if (time < tail_from) continue;
        double const expected = tail(point.fluid, time);
        inverse_times.push_back(1 / time);
        ratios.push_back({(values[lag] - std::exp(-2 * time / 3)) / expected, 1 / expected});
    }
    return line_through(inverse_times, ratios).at_0.value;
}

/// Margins: as a part of the slope; of C over C(0), what a rate of decay wrong by 1.4 % does where
/// it does most; as a part of the tail, for Enskog's coefficients in it and for how it is read.
constexpr double slope_margin = 0.015, decay_margin = 0.005, tail_margin = 1.0 / 3;

/// Enters what the replicates of a point say: the slope everywhere, the whole decay of the gas
/// beside the walks, the height of the tail, which the quick profile does not see well enough.
inline void enter(Ledger& ledger, StatePoint const& point, std::vector<Measurement> const& seen,
                  std::vector<Measurement> const& walks = {}) {
    std::vector<std::string> const state{cell(point.fluid.packing_fraction),
                                         cell(point.fluid.count)};
    if (point.part == Part::tail) {
        Quantity const quantity{"tail", "tail / expected"};
        auto const ratio = [&](Measurement const& values) { return tail_ratio(point, values); };
        Comparison const height{{}, mean_of(seen, ratio), 1, 0, tail_margin};
        if (point.is_long()) ledger.compare(state, quantity, height);
        if (!point.is_long()) ledger.guide(state, quantity, height);
        return;
    }
    double const interval = point.watch().interval;
    double const slope = initial_slope(point.fluid) / point.fluid.collision_rate();
    auto const begin = [&](Measurement const& m) { return measured_slope(m, interval); };
    ledger.compare(state, {"initial_slope", "$\\dot C(0)/\\nu C(0)$"},
                   {{}, mean_of(seen, begin), slope, 0, -slope_margin * slope});
    for (double const time : {0.5, 1.0, 2.0, 3.0, 4.0, 6.0}) {
        auto const lag = static_cast<std::size_t>(std::lround(time / interval));
        Quantity const quantity{"decay", fmt::format("$C({}/\\nu)/C(0)$", time)};
        Estimate const measured = mean_of(seen, lag);
        if (walks.empty()) { // Enskog's guess at a dense fluid
            ledger.guide(state, quantity, {{}, measured, std::exp(-2 * time / 3)});
        } else {
            Estimate const walked = mean_of(walks, lag);
            ledger.compare(state, quantity,
                           {{}, measured, walked.value, walked.error, decay_margin});
        }
    }
}

} // namespace clack::validation::velocity_autocorrelation
