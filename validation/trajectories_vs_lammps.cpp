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
    "engine's "
    "hard balls end, with an error that falls as the root of their stiffness?",
    "median distance 0.9 to 1.3 contact durations t_c; 1 % of the balls of short segments beyond "
    "5 t_c; slope of its logarithm -0.50 +- 0.03; median after Richardson 1e-5 and from hard balls "
    "with a yielding diameter 1e-6 with 1 % beyond 1e-5; 90 % of the balls kept at the hardest",
    "one or two collisions set a ball back by about v t_c / 2 each, and what is left is of the "
    "order "
    "t_c^2; balls whose collisions follow one another within 1.5 t_c are left out"};

namespace {

std::vector<Measured> measured(Experiment& experiment, std::string const& deck) {
    std::vector<Measured> all;
    for (StatePoint const& point : state_points(experiment.profile()))
        all.push_back({point, experiment.campaign().replicates(
                                  point.text(deck), point.replicates,
                                  [&](std::uint64_t seed) { return measure(point, seed, deck); })});
    return all;
}

Ledger ledger_of(std::vector<Measured> const& all) {
    Ledger ledger({{"packing_fraction", "$\\eta$"}, {"count", "$n$"}});
    for (Measured const& one : all) enter(ledger, one);
    for (double const packing : {0.2, 0.4}) {
        std::vector<Measured> some;
        std::copy_if(all.begin(), all.end(), std::back_inserter(some),
                     [&](Measured const& one) { return one.point.packing_fraction == packing; });
        for (Value const value : {plain_beyond, softened_beyond}) enter_beyond(ledger, some, value);
    }
    return ledger;
}

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

Csv csv_of(std::vector<Measured> const& all) {
    std::vector<std::string> names{"packing_fraction",   "count",     "stiffness",
                                   "contact_duration",   "is_judged", "kept_fraction",
                                   "kept_fraction_error"};
    for (std::string const quantity : {"distance", "richardson", "softened"}) {
        for (std::string const which : {"median", "largest"}) {
            names.push_back(fmt::format("{}_{}_per_diameter", quantity, which));
            names.push_back(fmt::format("{}_{}_per_diameter_error", quantity, which));
        }
    }
    Csv csv(names);
    for (Measured const& one : all) {
        for (std::size_t k = 0; k < one.point.stiffnesses.size(); ++k) {
            double const stiffness = one.point.stiffnesses[k];
            Estimate const kept = one.mean(k, kept_fraction);
            std::vector<std::string> cells{cell(one.point.packing_fraction),
                                           cell(one.point.count),
                                           cell(stiffness),
                                           cell(reference::contact_duration(stiffness)),
                                           cell(static_cast<int>(k >= one.point.first_judged)),
                                           cell(kept.value),
                                           cell(kept.error)};
            for (Value const value : {plain_median, plain_largest, richardson_median,
                                      richardson_largest, softened_median, softened_largest}) {
                Estimate const distance = typical(one, k, value);
                cells.push_back(cell(distance.value));
                cells.push_back(cell(distance.error));
            }
            csv.row(cells);
        }
    }
    return csv;
}

/// The matched beginnings of the sequences of collisions: for a figure, not judged.
Csv prefixes(Experiment& experiment, std::string const& deck) {
    Csv csv({"packing_fraction", "count", "stiffness", "contact_duration", "collisions_per_ball",
             "matched", "matched_error", "matched_softened", "matched_softened_error"});
    for (auto const& point : collision_prefix::state_points(experiment.profile())) {
        auto const replicates = experiment.campaign().replicates(
            point.text(deck), point.replicates,
            [&](std::uint64_t const seed) { return collision_prefix::measure(point, seed, deck); });
        for (std::size_t k = 0; k < point.stiffnesses.size(); ++k) {
            Estimate const hard = mean_of(replicates, 1 + 2 * k);
            Estimate const yielding = mean_of(replicates, 2 + 2 * k);
            csv.row({cell(point.packing_fraction), cell(point.count), cell(point.stiffnesses[k]),
                     cell(reference::contact_duration(point.stiffnesses[k])),
                     cell(mean_of(replicates, std::size_t{0}).value), cell(hard.value),
                     cell(hard.error), cell(yielding.value), cell(yielding.error)});
        }
    }
    return csv;
}

std::string table_of(std::vector<Measured> const& all, Ledger const& ledger) {
    std::vector<std::vector<std::string>> cells;
    for (Measured const& one : all) {
        std::size_t const last = one.point.stiffnesses.size() - 1;
        double const duration = reference::contact_duration(one.point.stiffnesses[last]);
        Estimate median = one.mean(last, plain_median);
        Estimate const slope =
            mean_of(one.replicates, [&](Measurement const& m) { return slope_of(one.point, m); });
        cells.push_back({fmt::format("{:.1f}", one.point.packing_fraction), cell(one.point.count),
                         "$" + with_error(slope) + "$",
                         with_error({median.value / duration, median.error / duration}),
                         significant(one.mean(last - 1, richardson_median).value, 2),
                         significant(one.mean(last, softened_median).value, 2),
                         fmt::format("{:.2f}", one.mean(last, kept_fraction).value),
                         name_of(ledger.verdict_at(one.state()))});
    }
    return tabular("rrrrrrrl",
                   {"$\\eta$", "$n$", "slope", "median$/t_{\\mathrm c}$", "Richardson", "yielding",
                    "kept", "verdict"},
                   cells);
}

Macros macros_of(std::vector<Measured> const& all) {
    double richardson = 0, softened = 0, least_kept = 1, most_kept = 0, segments = 0;
    for (Measured const& one : all) {
        std::size_t const last = one.point.stiffnesses.size() - 1, first = one.point.first_judged;
        richardson = std::max(richardson, one.mean(first, richardson_median).value);
        softened = std::max(softened, one.mean(first, softened_median).value);
        least_kept = std::min(least_kept, one.mean(0, kept_fraction).value);
        most_kept = std::max(most_kept, one.mean(last, kept_fraction).value);
        segments += one.point.segments * one.point.replicates;
    }
    Macros macros("TrajectoriesVsLammps");
    macros.define("Version", reference::lammps_version);
    macros.define("Segments", cell(static_cast<std::int64_t>(segments)));
    macros.define("StepsPerContact", significant(steps_per_contact, 3));
    macros.define("Richardson", significant(richardson, 2));
    macros.define("Softened", significant(softened, 2));
    macros.define("LeastKeptPercent", fmt::format("{:.0f}", 100 * least_kept));
    macros.define("MostKeptPercent", fmt::format("{:.0f}", 100 * most_kept));
    return macros;
}

} // namespace

Verdict ask(Experiment& experiment) {
    std::string const deck = reference::lammps_deck("lammps_cube.in");
    std::vector<Measured> const all = measured(experiment, deck);
    Csv const prefix = prefixes(experiment, deck);
    Ledger ledger = ledger_of(all);
    Verdict const verdict = conclude(experiment, ledger, macros_of(all), risks);
    experiment.write(csv_of(all), "_distances");
    experiment.write(prefix, "_prefix");
    experiment.write_table(table_of(all, ledger));
    return verdict;
}

} // namespace clack::validation
