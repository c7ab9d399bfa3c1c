#pragma once
// How the pressure depends on the number of balls: state points, one measurement, and the law.

#include "validation/harness/findings.hpp"
#include "validation/periodic_run.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace clack::validation::system_size {

struct StatePoint {
    PeriodicRun run;
    int replicates;
};

/// Where images spoil the law, a ball being too near its own: below 100 balls at this density
/// (32 balls lie 0.3 % above the law, reference/periodic_md.csv). Shown, not judged.
constexpr std::int64_t fewest_judged = 100;

/// One fluid, of number density 0.5, in ever larger cubes. In the quick profile the largest are
/// left out, as their 1/N term is below what it can resolve.
inline std::vector<StatePoint> state_points(Profile const profile) {
    double const eta = 0.5 * std::numbers::pi / 6;
    std::vector<std::int64_t> counts{32, 64, 108, 256, 500, 1372, 4000};
    if (profile == Profile::full) counts.insert(counts.end(), {10'976, 32'000});
    double const all = profile == Profile::quick ? 1e6 : 3e7; // collisions of one ball, over balls
    std::vector<StatePoint> points;
    for (std::int64_t const count : counts) {
        // So small a cube as that of 32 takes the method that asks every pair. All are given long
        // to forget where their balls were put, as large cubes need.
        double const part = count == 32 ? 0.1 : count < fewest_judged ? 0.25 : 1;
        points.push_back({{eta, count, 300, part * all / static_cast<double>(count)}, 16});
    }
    return points;
}

/// Z of N balls from the rate of the collisions, which scatters less than their virial.
inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(point.run.scene(seed));
    return {run_periodic(point.run, *engine).by_rate};
}

/// The slope of Z against 1/N, and Z where 1/N is 0.
struct Line {
    Estimate slope, limit;
};

/// A straight line by least squares with the measured errors as weights.
inline Line line_through(std::vector<double> const& x, std::vector<Estimate> const& y) {
    double weights = 0, mean_x = 0, mean_y = 0, spread = 0, slope = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        double const weight = 1 / (y[k].error * y[k].error);
        weights += weight;
        mean_x += weight * x[k];
        mean_y += weight * y[k].value;
    }
    mean_x /= weights;
    mean_y /= weights;
    for (std::size_t k = 0; k < x.size(); ++k) {
        double const weight = 1 / (y[k].error * y[k].error);
        spread += weight * (x[k] - mean_x) * (x[k] - mean_x);
        slope += weight * (x[k] - mean_x) * (y[k].value - mean_y);
    }
    slope /= spread;
    return {{slope, std::sqrt(1 / spread)},
            {mean_y - slope * mean_x, std::sqrt(1 / weights + mean_x * mean_x / spread)}};
}

/// 0.15 % of Zc at each number; for the slope of Z against 1/N a third of it, where N in the place
/// of N - 1 anywhere in temperature or momentum makes one of about Zc, as large as itself or more.
constexpr double margin = 1.5e-3, slope_margin = 1.0 / 3;

inline void add_findings(Findings& findings, std::vector<StatePoint> const& points,
                         std::vector<std::vector<Measurement>> const& all) {
    std::vector<double> inverses;
    std::vector<Estimate> judged;
    double const rho = points.front().run.number_density();
    for (std::size_t k = 0; k < points.size(); ++k) {
        std::int64_t const count = points[k].run.count;
        if (count < fewest_judged) continue;
        judged.push_back(mean_of(all[k], 0));
        inverses.push_back(1 / static_cast<double>(count));
        double const zc = reference::collisional_compressibility(rho, count);
        findings.add({"Z",
                      "$Z$",
                      static_cast<double>(count),
                      {.measured = judged.back(),
                       .reference = reference::periodic_compressibility(rho, count),
                       .margin = margin * zc}});
    }
    Line const line = line_through(inverses, judged);
    double const infinite = reference::modified_klm(points.front().run.packing_fraction);
    double const slope = reference::periodic_compressibility(rho, 2) - infinite; // half of it
    findings.add({"slope",
                  "slope of $Z$ against $1/n$",
                  0,
                  {.measured = line.slope,
                   .reference = 2 * slope,
                   .margin = slope_margin * std::abs(2 * slope)}});
    findings.add(
        {"limit",
         "$Z$ of infinitely many",
         0,
         {.measured = line.limit, .reference = infinite, .margin = margin * (infinite - 1)}});
}

} // namespace clack::validation::system_size
