#pragma once
// How the pressure depends on the number of balls: state points, one measurement, and the law.

#include "validation/harness/ledger.hpp"
#include "validation/periodic_run.hpp"
#include "validation/statistics/estimate.hpp"

#include <cmath>
#include <vector>

namespace clack::validation::system_size {

/// Where images spoil the law, a ball being too near its own: below 100 balls at this density
/// (32 balls lie 0.3 % above the law, reference/periodic_md.csv). Shown, not judged.
constexpr std::int64_t fewest_judged = 100;

/// One fluid, of number density 0.5, in ever larger cubes. In the quick profile the largest are
/// left out, as their 1/N term is below what it can resolve.
inline std::vector<PeriodicRun> state_points(Profile const profile) {
    double const eta = 0.5 * std::numbers::pi / 6;
    std::vector<std::int64_t> counts{32, 64, 108, 256, 500, 1372, 4000};
    if (profile == Profile::full) counts.insert(counts.end(), {10'976, 32'000});
    double const all = profile == Profile::quick ? 1e6 : 3e7; // collisions of one ball, over balls
    std::vector<PeriodicRun> points;
    for (std::int64_t const count : counts) {
        // So small a cube as that of 32 takes the method that asks every pair. All are given long
        // to forget where their balls were put, as large cubes need.
        double const part = count == 32 ? 0.1 : count < fewest_judged ? 0.25 : 1;
        points.push_back({{eta, count}, 300, part * all / static_cast<double>(count)});
    }
    return points;
}

/// Z of N balls from the rate of the collisions, which scatters less than their virial.
inline Measurement measure(PeriodicRun const& run, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(run.scene(seed));
    return {run_periodic(run, *engine).by_rate};
}

/// 0.15 % of Zc at each number; for the slope of Z against 1/N a third of it, where N in the place
/// of N - 1 anywhere in temperature or momentum makes one of about Zc, as large as itself or more.
constexpr double margin = 1.5e-3, slope_margin = 1.0 / 3;

inline void enter(Ledger& ledger, std::vector<PeriodicRun> const& points,
                  std::vector<std::vector<Measurement>> const& all) {
    std::vector<double> inverses;
    std::vector<Estimate> judged;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (points[k].count < fewest_judged) continue;
        judged.push_back(mean_of(all[k], 0));
        inverses.push_back(1 / static_cast<double>(points[k].count));
        ledger.compare({cell(points[k].count)}, {"Z", "$Z$"},
                       {.measured = judged.back(),
                        .reference = points[k].expected(),
                        .margin = margin * points[k].collisional()});
    }
    MeasuredLine const line = line_through(inverses, judged);
    PeriodicRun const& any = points.back();
    double const infinite = any.expected_of_infinitely_many();
    double const slope = (any.expected() - infinite) * static_cast<double>(any.count);
    ledger.compare(
        {"all"}, {"slope", "slope of $Z$ against $1/n$"},
        {.measured = line.slope, .reference = slope, .margin = slope_margin * std::abs(slope)});
    ledger.compare(
        {"all"}, {"limit", "$Z$ of infinitely many"},
        {.measured = line.at_0, .reference = infinite, .margin = margin * (infinite - 1)});
}

} // namespace clack::validation::system_size
