// Do energy, momentum and the distances at contact keep to rounding over a long run?

#include "validation/conservation.hpp"

#include "validation/harness/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace clack::validation {

using namespace conservation;

Question const question{
    "conservation",
    "Do energy, momentum and the distances of balls and walls in contact keep to rounding over a "
    "long run?",
    "energy and momentum: 4 (2 + sqrt(collisions per ball)) roundings; overlap: 16 roundings of a "
    "place and of the flight of one epoch; walls: two roundings of the side",
    "rounding errors wander; these are sixteen standard errors of it, so that chance plays no "
    "part, "
    "and those of the overlap do not grow with the length of the run",
    Processes::one_a_state_point};

namespace {

struct Run {
    StatePoint point;
    System system;
    std::vector<Moment> moments;

    Verdict verdict() const {
        bool const all = std::all_of(moments.begin(), moments.end(),
                                     [&](Moment const& moment) { return holds(moment, system); });
        return all ? Verdict::agrees : Verdict::differs;
    }
};

Measurement flat(std::vector<Moment> const& moments) {
    Measurement numbers;
    for (Moment const& m : moments)
        numbers.insert(numbers.end(), {m.collisions_per_ball, m.energy_drift, m.momentum,
                                       m.deepest_overlap, m.wall_distance});
    return numbers;
}

std::vector<Moment> unflat(Measurement const& numbers) {
    std::vector<Moment> moments;
    for (std::size_t k = 0; k + 4 < numbers.size(); k += 5)
        moments.push_back(
            {numbers[k], numbers[k + 1], numbers[k + 2], numbers[k + 3], numbers[k + 4]});
    return moments;
}

Csv csv_of(std::vector<Run> const& runs) {
    Csv csv({"boundary", "packing_fraction", "count", "collisions_per_ball", "energy_drift",
             "momentum_change", "drift_bound", "deepest_overlap_per_diameter",
             "overlap_bound_per_diameter", "wall_distance_error_per_diameter",
             "wall_bound_per_diameter"});
    for (Run const& run : runs)
        for (Moment const& m : run.moments)
            csv.row({cell(std::string(run.point.boundary_name())), cell(run.point.packing_fraction),
                     cell(run.point.count), cell(m.collisions_per_ball),
                     cell(std::abs(m.energy_drift)), cell(m.momentum),
                     cell(drift_bound(m.collisions_per_ball)), cell(m.deepest_overlap),
                     cell(overlap_bound(run.system)), cell(m.wall_distance),
                     cell(wall_bound(run.system))});
    return csv;
}

Macros macros_of(std::vector<Run> const& runs, Verdict const verdict) {
    double energy = 0, momentum = 0, overlap = 0, wall = 0;
    for (Run const& run : runs) {
        for (Moment const& m : run.moments) {
            energy = std::max(energy, std::abs(m.energy_drift));
            momentum = std::max(momentum, m.momentum);
            overlap = std::max(overlap, m.deepest_overlap);
            wall = std::max(wall, m.wall_distance);
        }
    }
    Macros macros("Conservation");
    macros.define("Balls", cell(runs.front().point.count));
    macros.define("CollisionsPerBall", cell(runs.front().point.collisions_per_ball));
    macros.define("EnergyDrift", significant(energy, 2));
    macros.define("MomentumChange", significant(momentum, 2));
    macros.define("DeepestOverlap", significant(overlap, 2));
    macros.define("WallDistance", significant(wall, 2));
    macros.define("Verdict", name_of(verdict));
    return macros;
}

} // namespace

Verdict ask(Experiment& experiment) {
    std::vector<Run> runs;
    std::vector<Verdict> verdicts;
    auto const points = state_points(experiment.profile());
    auto const replicates = experiment.campaign().replicates(
        tasks_of(points, [](StatePoint const& point, std::uint64_t const seed) {
            return flat(measure(point, seed));
        }));
    for (std::size_t k = 0; k < points.size(); ++k) {
        StatePoint const& point = points[k];
        runs.push_back({point, point.scene(0).system, unflat(replicates[k].front())});
        Run const& run = runs.back();
        verdicts.push_back(run.verdict());
        Moment const& last = run.moments.back();
        std::cout << fmt::format("{:8} packing fraction {:.2f}, {} collisions a ball: energy drift "
                                 "{:+.1e}, momentum {:.1e} (bound {:.1e}), overlap {:.1e} (bound "
                                 "{:.1e}), wall {:.1e} (bound {:.1e})  {}\n",
                                 point.boundary_name(), point.packing_fraction,
                                 last.collisions_per_ball, last.energy_drift, last.momentum,
                                 drift_bound(last.collisions_per_ball), last.deepest_overlap,
                                 overlap_bound(run.system), last.wall_distance,
                                 wall_bound(run.system), name_of(run.verdict()));
    }
    Verdict const verdict = together(verdicts);
    experiment.write(csv_of(runs));
    experiment.write(macros_of(runs, verdict));
    return verdict;
}

} // namespace clack::validation
