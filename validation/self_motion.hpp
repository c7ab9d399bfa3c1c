#pragma once
// The motion of single balls in a periodic fluid: shared by self_diffusion and
// velocity_autocorrelation.

#include "observables/self_correlation.hpp"
#include "validation/periodic_fluid.hpp"

#include <cmath>

namespace clack::validation {

/// How long and how closely one looks, in mean free times.
struct Watch {
    double interval;       // between snapshots
    double longest;        // lag
    double origin_spacing; // between origins of time
    double production;     // of one replicate, beyond the longest lag
};

inline SelfCorrelation watch_balls(PeriodicFluid const& fluid, Watch const& watch,
                                   std::uint64_t const seed, EngineMaker const& make) {
    constexpr double equilibration = 50; // collisions per ball
    auto const engine = fluid.start(seed, equilibration, make);
    auto const lags = static_cast<std::size_t>(std::lround(watch.longest / watch.interval));
    SelfCorrelation correlation(
        fluid.side(), lags,
        static_cast<std::size_t>(std::lround(watch.origin_spacing / watch.interval)));
    double const interval = watch.interval / fluid.collision_rate();
    auto const looks = std::lround((watch.longest + watch.production) / watch.interval);
    for (long look = 0; look <= looks; ++look) {
        engine->advance({.time = static_cast<double>(look) * interval});
        correlation.add(engine->snapshot());
    }
    return correlation;
}

/// Initial slope of the logarithm of the velocity autocorrelation, exact at every density and
/// number of balls: each collision of a ball takes half of <v_n^2> = (4 kT/m) D/(D+1) off <v.v'>,
/// which begins at <v^2> = 3 (kT/m) (N-1)/N. For infinitely many balls -2/3 of the collision rate.
inline double initial_slope(PeriodicFluid const& fluid) {
    auto const n = static_cast<double>(fluid.count);
    double const freedom = 3 * n - 3;
    return -2.0 / 3 * fluid.collision_rate() * freedom / (freedom + 1) * n / (n - 1);
}

} // namespace clack::validation
