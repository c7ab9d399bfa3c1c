// Do energy, momentum and the distances at contact keep to rounding over a long run?

#include "validation/conservation.hpp"

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

Run run_of(StatePoint const& point, Measurement const& flat) {
    Run run{point, point.scene(0).system, {}};
    for (std::size_t k = 0; k + 4 < flat.size(); k += 5)
        run.moments.push_back({flat[k], flat[k + 1], flat[k + 2], flat[k + 3], flat[k + 4]});
    return run;
}

Csv csv_of(std::vector<Run> const& runs) {
    Csv csv({"boundary", "packing_fraction", "count", "collisions_per_ball", "energy_drift",
             "momentum_change", "drift_bound", "deepest_overlap_per_diameter",
             "overlap_bound_per_diameter", "wall_distance_error_per_diameter",
             "wall_bound_per_diameter"});
    for (auto const& [point, system, moments] : runs)
        for (Moment const& m : moments)
            csv.row(point.boundary_name(), point.packing_fraction, point.count,
                    m.collisions_per_ball, std::abs(m.energy_drift), m.momentum,
                    drift_bound(m.collisions_per_ball), m.deepest_overlap, overlap_bound(system),
                    m.wall_distance, wall_bound(system));
    return csv;
}

std::string line_of(Run const& run) {
    Moment const& last = run.moments.back();
    return fmt::format("{:8} packing fraction {:.2f}, {} collisions a ball: energy drift {:+.1e}, "
                       "momentum {:.1e} (bound {:.1e}), overlap {:.1e} (bound {:.1e}), wall {:.1e} "
                       "(bound {:.1e})  {}\n",
                       run.point.boundary_name(), run.point.packing_fraction,
                       last.collisions_per_ball, last.energy_drift, last.momentum,
                       drift_bound(last.collisions_per_ball), last.deepest_overlap,
                       overlap_bound(run.system), last.wall_distance, wall_bound(run.system),
                       name_of(run.verdict()));
}

Macros macros_of(std::vector<Run> const& runs) {
    double energy = 0, momentum = 0, overlap = 0, wall = 0;
    for (Run const& run : runs)
        for (Moment const& m : run.moments) {
            energy = std::max(energy, std::abs(m.energy_drift));
            momentum = std::max(momentum, m.momentum);
            overlap = std::max(overlap, m.deepest_overlap);
            wall = std::max(wall, m.wall_distance);
        }
    Macros macros("Conservation");
    macros.define("Balls", cell(runs.front().point.count));
    macros.define("CollisionsPerBall", cell(runs.front().point.collisions_per_ball));
    macros.define("EnergyDrift", significant(energy, 2));
    macros.define("MomentumChange", significant(momentum, 2));
    macros.define("DeepestOverlap", significant(overlap, 2));
    macros.define("WallDistance", significant(wall, 2));
    return macros;
}

} // namespace

Verdict ask(Experiment& experiment) {
    auto const points = state_points(experiment.profile());
    auto const replicates = experiment.campaign().replicates(
        tasks_of(points, [](StatePoint const& point, std::uint64_t const seed) {
            return flat(measure(point, seed));
        }));
    std::vector<Run> runs;
    std::vector<Verdict> verdicts;
    for (std::size_t k = 0; k < points.size(); ++k) {
        runs.push_back(run_of(points[k], replicates[k].front()));
        verdicts.push_back(runs.back().verdict());
        std::cout << line_of(runs.back());
    }
    experiment.write(csv_of(runs));
    experiment.write(macros_of(runs));
    return together(verdicts);
}

} // namespace clack::validation
