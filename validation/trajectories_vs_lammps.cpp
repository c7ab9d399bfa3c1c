// Do soft elastic balls, as LAMMPS moves them, tend to the engine's trajectories as they harden?

#include "validation/trajectories_vs_lammps.hpp"

#include "validation/collision_prefix.hpp"
#include "validation/harness/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace clack::validation {

namespace {

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

/// All comparisons with their judgements, and whose they are.
struct Gates {
    std::vector<Comparison> comparisons;
    std::vector<Judgement> judgements;

    /// Of those whose name begins so.
    Verdict verdict(std::string const& name) const {
        std::vector<Judgement> some;
        for (std::size_t k = 0; k < comparisons.size(); ++k)
            if (comparisons[k].name.starts_with(name)) some.push_back(judgements[k]);
        return together(some);
    }
};

std::vector<Measured> measured(Experiment& experiment, std::string const& deck) {
    std::vector<Measured> all;
    for (StatePoint const& point : state_points(experiment.profile())) {
        all.push_back({point, experiment.campaign().replicates(point.text(deck), point.replicates,
                                                               [&](std::uint64_t const seed) {
                                                                   return measure(point, seed,
                                                                                  deck);
                                                               })});
    }
    return all;
}

Gates gates_of(std::vector<Measured> const& all) {
    Gates gates;
    for (Measured const& one : all)
        for (Comparison const& comparison : comparisons(one))
            gates.comparisons.push_back(comparison);
    for (double const packing : {0.2, 0.4}) {
        std::vector<Measured> some;
        std::copy_if(all.begin(), all.end(), std::back_inserter(some),
                     [&](Measured const& one) { return one.point.packing_fraction == packing; });
        for (Value const value : {plain_beyond, softened_beyond})
            gates.comparisons.push_back(beyond(some, value));
    }
    gates.judgements = judge(gates.comparisons, risks);
    return gates;
}

/// Geometric mean of distances: they range over decades. Not a number where there are none.
Estimate typical(Measured const& one, std::size_t const level, Value const value) {
    std::vector<double> logarithms;
    for (double const x : values_of(one.replicates, level, value)) {
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

Csv csv_of(Gates const& gates) {
    Csv csv({"what", "measured", "error", "reference", "margin", "z", "verdict"});
    for (std::size_t k = 0; k < gates.comparisons.size(); ++k) {
        Comparison const& c = gates.comparisons[k];
        std::string name = c.name;
        std::replace(name.begin(), name.end(), ',', ';');
        csv.row({name, cell(c.measured.value), cell(c.measured.error), cell(c.reference),
                 cell(c.margin), cell(gates.judgements[k].z),
                 cell(name_of(gates.judgements[k].verdict))});
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
        auto const mean = [&](std::size_t const place) {
            std::vector<double> values;
            for (Measurement const& replicate : replicates) values.push_back(replicate[place]);
            return mean_of(values);
        };
        for (std::size_t k = 0; k < point.stiffnesses.size(); ++k) {
            Estimate const hard = mean(1 + 2 * k), yielding = mean(2 + 2 * k);
            csv.row({cell(point.packing_fraction), cell(point.count), cell(point.stiffnesses[k]),
                     cell(reference::contact_duration(point.stiffnesses[k])), cell(mean(0).value),
                     cell(hard.value), cell(hard.error), cell(yielding.value),
                     cell(yielding.error)});
        }
    }
    return csv;
}

std::string table_of(std::vector<Measured> const& all, Gates const& gates) {
    std::vector<std::vector<std::string>> cells;
    std::size_t first = 0; // the slopes are the first comparisons of their points
    for (Measured const& one : all) {
        std::size_t const last = one.point.stiffnesses.size() - 1;
        double const duration = reference::contact_duration(one.point.stiffnesses[last]);
        Estimate median = one.mean(last, plain_median);
        cells.push_back({fmt::format("{:.1f}", one.point.packing_fraction), cell(one.point.count),
                         "$" + with_error(gates.comparisons[first].measured) + "$",
                         with_error({median.value / duration, median.error / duration}),
                         significant(one.mean(last - 1, richardson_median).value, 2),
                         significant(one.mean(last, softened_median).value, 2),
                         fmt::format("{:.2f}", one.mean(last, kept_fraction).value),
                         name_of(gates.verdict(one.name() + ":"))});
        first += comparisons(one).size();
    }
    return tabular("rrrrrrrl",
                   {"$\\eta$", "$n$", "slope", "median$/t_{\\mathrm c}$", "Richardson", "yielding",
                    "kept", "verdict"},
                   cells);
}

Macros macros_of(std::vector<Measured> const& all, Profile const profile, Verdict const verdict) {
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
    macros.define("Profile", name_of(profile));
    macros.define("Version", reference::lammps_version);
    macros.define("Segments", cell(static_cast<std::int64_t>(segments)));
    macros.define("StepsPerContact", significant(steps_per_contact, 3));
    macros.define("Richardson", significant(richardson, 2));
    macros.define("Softened", significant(softened, 2));
    macros.define("LeastKeptPercent", fmt::format("{:.0f}", 100 * least_kept));
    macros.define("MostKeptPercent", fmt::format("{:.0f}", 100 * most_kept));
    macros.define("Verdict", name_of(verdict));
    return macros;
}

Verdict ask(Experiment& experiment) {
    std::string const deck = reference::lammps_deck("lammps_cube.in");
    std::vector<Measured> const all = measured(experiment, deck);
    Csv const prefix = prefixes(experiment, deck);
    Gates const gates = gates_of(all);
    for (std::size_t k = 0; k < gates.comparisons.size(); ++k) {
        Comparison const& c = gates.comparisons[k];
        std::cout << fmt::format("{}: {:.4g} +- {:.1g}, expected {} +- {}: z = {:+.1f}  {}\n",
                                 c.name, c.measured.value, c.measured.error, c.reference, c.margin,
                                 gates.judgements[k].z, name_of(gates.judgements[k].verdict));
    }
    Verdict const verdict = together(gates.judgements);
    experiment.write(csv_of(all));
    experiment.write(csv_of(gates), "_gates");
    experiment.write(prefix, "_prefix");
    experiment.write(macros_of(all, experiment.profile(), verdict));
    experiment.write_table(table_of(all, gates));
    return verdict;
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask);
}
