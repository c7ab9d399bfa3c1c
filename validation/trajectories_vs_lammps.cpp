// Do soft elastic balls, as LAMMPS moves them, tend to the engine's trajectories as they harden?

#include "validation/trajectories_vs_lammps.hpp"

#include "validation/collision_prefix.hpp"
#include "validation/harness/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace clack::validation {

using namespace trajectories_vs_lammps;

Question const question{
    "trajectories_vs_lammps",
    "Do soft elastic balls between walls, as LAMMPS moves them step by step, end where the "
    "engine's hard balls end, with an error that falls as the root of their stiffness?",
    "median distance 0.9 to 1.3 contact durations t_c; 1 % of the balls of short segments beyond "
    "5 t_c; slope of its logarithm -0.50 +- 0.03; median after Richardson 1e-5 and from hard balls "
    "with a yielding diameter 1e-6 with 1 % beyond 1e-5; 90 % of the balls kept at the hardest",
    "one or two collisions set a ball back by about v t_c / 2 each, and what is left is of the "
    "order t_c^2; balls whose collisions follow one another within 1.5 t_c are left out"};

namespace {

/// Geometric mean of distances: they range over decades. Not a number where there are none.
Estimate typical(Measured const& one, std::size_t const level, Value const value) {
    std::vector<double> logarithms;
    for (Measurement const& replicate : one.replicates) {
        double const x = replicate[level * value_count + value];
        if (!(x > 0)) return {std::numeric_limits<double>::quiet_NaN(), 0};
        logarithms.push_back(std::log(x));
    }
    Estimate const mean = mean_of(logarithms);
    return {std::exp(mean.value), std::exp(mean.value) * mean.error, mean.degrees_of_freedom};
}

/// What the figure draws, by stiffness; the matched beginnings of the sequences of collisions,
/// which are not judged, are measured for it.
Csv curves_of(std::vector<Measured> const& all, Experiment& experiment) {
    Csv csv({"packing_fraction", "count", "stiffness", "quantity", "value", "error"});
    auto const add = [&](auto const& point, std::size_t const k, char const* quantity,
                         Estimate const& found) {
        csv.row({cell(point.packing_fraction), cell(point.count), cell(point.stiffnesses[k]),
                 quantity, cell(found.value), cell(found.error)});
    };
    for (Measured const& one : all) {
        for (std::size_t k = 0; k <= one.hardest(); ++k) {
            add(one.point, k, "kept", one.mean(k, kept_fraction));
            for (auto const& [quantity, value] : {std::pair{"distance_median", plain_median},
                                                  {"distance_largest", plain_largest},
                                                  {"richardson_median", richardson_median},
                                                  {"richardson_largest", richardson_largest},
                                                  {"softened_median", softened_median},
                                                  {"softened_largest", softened_largest}})
                add(one.point, k, quantity, typical(one, k, value));
        }
    }
    for (auto const& point : collision_prefix::state_points(experiment.profile())) {
        auto const replicates = experiment.campaign().replicates(
            point.text(), point.replicates,
            [&](std::uint64_t const seed) { return collision_prefix::measure(point, seed); });
        for (std::size_t k = 0; k < point.stiffnesses.size(); ++k) {
            add(point, k, "matched", mean_of(replicates, 1 + 2 * k));
            add(point, k, "matched_softened", mean_of(replicates, 2 + 2 * k));
        }
    }
    return csv;
}

Macros macros_of(std::vector<Measured> const& all) {
    std::vector<double> slopes, richardson, softened, kept;
    int segments = 0;
    for (Measured const& one : all) {
        std::size_t const first = one.point.first_judged;
        slopes.push_back(one.slope().value);
        richardson.push_back(one.mean(first, richardson_median).value);
        softened.push_back(one.mean(first, softened_median).value);
        for (std::size_t const k : {std::size_t{0}, one.hardest()})
            kept.push_back(100 * one.mean(k, kept_fraction).value);
        segments += one.point.segments * static_cast<int>(one.replicates.size());
    }
    Macros macros("TrajectoriesVsLammps");
    macros.define("Version", reference::lammps_version);
    macros.define("Segments", cell(segments));
    macros.define("StepsPerContact", significant(steps_per_contact, 3));
    macros.define("SteepestSlope", fmt::format("{:.4f}", std::ranges::min(slopes)));
    macros.define("FlattestSlope", fmt::format("{:.4f}", std::ranges::max(slopes)));
    macros.define("Richardson", significant(std::ranges::max(richardson), 2));
    macros.define("Softened", significant(std::ranges::max(softened), 2));
    macros.define("LeastKeptPercent", fmt::format("{:.0f}", std::ranges::min(kept)));
    macros.define("MostKeptPercent", fmt::format("{:.0f}", std::ranges::max(kept)));
    return macros;
}

} // namespace

Verdict ask(Experiment& experiment) {
    std::vector<Measured> all;
    Ledger ledger({{"packing_fraction", "$\\eta$"}, {"count", "$n$"}});
    auto const points = state_points(experiment.profile());
    auto const by_lammps = [](StatePoint const& point, std::uint64_t const seed) {
        return measure(point, seed);
    };
    auto const replicates = experiment.campaign().replicates(tasks_of(points, by_lammps));
    for (std::size_t p = 0; p < points.size(); ++p)
        enter(ledger, all.emplace_back(Measured{points[p], replicates[p]}));
    for (double const packing_fraction : {0.2, 0.4})
        for (Value const value : {plain_beyond, softened_beyond})
            enter_beyond(ledger, all, packing_fraction, value);
    experiment.write(curves_of(all, experiment), "_curves");
    return conclude(experiment, ledger, macros_of(all), risks);
}

} // namespace clack::validation
