// Does the pressure of the fluid obey its equation of state, finite-size term included?

#include "validation/equation_of_state.hpp"

#include "validation/harness/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

namespace clack::validation {

namespace {

using namespace equation_of_state;

Question const question{
    "equation_of_state",
    "Does the pressure of a periodic fluid of hard balls, by virial and by collision rate, obey "
    "the modified Kolafa-Labik-Malijevsky equation of state with its 1/N term?",
    "0.2 % of the collisional part Zc (full profile 0.1 %): two thirds (one third) of what a "
    "diameter wrong by 0.1 % does where it does least"};

/// A state point with all that was found out about it.
struct Row {
    StatePoint point;
    Comparison virial, rate;
    double error_by_blocking; // of the virial's, beside the one over replicates
    Judgement virial_judged, rate_judged;

    double theory() const { return reference::modified_klm(point.packing_fraction); }
    /// Measured compressibility factor of infinitely many balls: the theory's difference between
    /// these and N is taken off.
    Estimate compressibility() const {
        return {theory() + virial.measured.value - virial.reference, virial.measured.error,
                virial.measured.degrees_of_freedom};
    }
    double collisions() const {
        return point.replicates * point.production * static_cast<double>(point.count) / 2;
    }
    Verdict verdict() const {
        return together(std::vector{virial_judged.verdict, rate_judged.verdict});
    }
};

std::vector<Row> measured(Experiment& experiment) {
    std::vector<Row> rows;
    std::vector<Comparison> comparisons;
    double const relative_margin = margin(experiment.profile());
    auto const points = state_points(experiment.profile());
    auto const replicates = experiment.campaign().replicates(tasks_of(
        points, [](StatePoint const& point, std::uint64_t seed) { return measure(point, seed); }));
    for (std::size_t k = 0; k < points.size(); ++k) {
        rows.push_back({points[k],
                        compare(points[k], replicates[k], by_virial, relative_margin),
                        compare(points[k], replicates[k], by_rate, relative_margin),
                        error_by_blocking(replicates[k]),
                        {},
                        {}});
        comparisons.push_back(rows.back().virial);
        comparisons.push_back(rows.back().rate);
    }
    auto const judgements = judge(comparisons);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].virial_judged = judgements[2 * k];
        rows[k].rate_judged = judgements[2 * k + 1];
    }
    return rows;
}

Csv csv_of(std::vector<Row> const& rows) {
    Csv csv({"packing_fraction", "count", "number_density_per_diameter3", "replicates",
             "collisions", "Z_virial", "Z_virial_error", "Z_rate", "Z_rate_error", "Z_theory",
             "margin", "z_virial", "z_rate", "Z_infinite", "Z_infinite_error", "Z_infinite_theory",
             "Z_infinite_carnahan_starling", "verdict", "Z_virial_error_by_blocking"});
    for (Row const& row : rows)
        csv.row({cell(row.point.packing_fraction), cell(row.point.count),
                 cell(row.point.number_density()), cell(row.point.replicates),
                 cell(row.collisions()), cell(row.virial.measured.value),
                 cell(row.virial.measured.error), cell(row.rate.measured.value),
                 cell(row.rate.measured.error), cell(row.virial.reference), cell(row.virial.margin),
                 cell(row.virial_judged.z), cell(row.rate_judged.z),
                 cell(row.compressibility().value), cell(row.compressibility().error),
                 cell(row.theory()), cell(reference::carnahan_starling(row.point.packing_fraction)),
                 cell(name_of(row.verdict())), cell(row.error_by_blocking)});
    return csv;
}

/// The theories as lines.
Csv curves() {
    Csv csv({"packing_fraction", "Z_theory", "Z_carnahan_starling"});
    for (int percent = 0; percent <= 50; ++percent) {
        double const eta = percent / 100.0;
        csv.row({cell(eta), cell(reference::modified_klm(eta)),
                 cell(reference::carnahan_starling(eta))});
    }
    return csv;
}

std::string table_of(std::vector<Row> const& rows) {
    std::vector<std::vector<std::string>> cells;
    for (Row const& row : rows)
        cells.push_back({fmt::format("{:.2f}", row.point.packing_fraction), cell(row.point.count),
                         with_error(row.compressibility()), fmt::format("{:.5f}", row.theory()),
                         fmt::format("${:+.1f}$", row.virial_judged.z),
                         fmt::format("${:+.1f}$", row.rate_judged.z), name_of(row.verdict())});
    return tabular("rrlrrrl",
                   {"$\\eta$", "$n$", "$Z$", "$Z$ theory", "$z$ virial", "$z$ rate", "verdict"},
                   cells);
}

Macros macros_of(std::vector<Row> const& rows, Profile const profile, Verdict const verdict) {
    double collisions = 0, largest_z = 0, largest_deviation = 0, squared_ratio = 0;
    for (Row const& row : rows) {
        collisions += row.collisions();
        squared_ratio += std::pow(row.error_by_blocking / row.virial.measured.error, 2) /
                         static_cast<double>(rows.size());
        for (auto const& [comparison, judgement] :
             {std::pair{row.virial, row.virial_judged}, {row.rate, row.rate_judged}}) {
            largest_z = std::max(largest_z, std::abs(judgement.z));
            largest_deviation = std::max(
                largest_deviation, std::abs(comparison.measured.value / comparison.reference - 1));
        }
    }
    Macros macros("EquationOfState");
    macros.define("Profile", name_of(profile));
    macros.define("Points", cell(rows.size()));
    macros.define("Collisions", significant(collisions, 2));
    macros.define("LowestPacking", fmt::format("{:.2f}", rows.front().point.packing_fraction));
    macros.define("HighestPacking", fmt::format("{:.2f}", rows.back().point.packing_fraction));
    macros.define("LargestZ", significant(largest_z, 2));
    macros.define("LargestDeviationPercent", significant(100 * largest_deviation, 2));
    macros.define("MarginPercent", significant(100 * margin(profile), 1));
    macros.define("BlockingRatio", significant(std::sqrt(squared_ratio), 2));
    macros.define("FalseAlarmPercent", significant(100 * Risks{}.false_alarm, 1));
    macros.define("Verdict", name_of(verdict));
    return macros;
}

Verdict ask(Experiment& experiment) {
    std::vector<Row> const rows = measured(experiment);
    std::vector<Verdict> verdicts;
    for (Row const& row : rows) {
        verdicts.push_back(row.verdict());
        std::cout << fmt::format("packing fraction {:.2f}, {:4} balls: Z = {:<12} theory {:8.5f}  "
                                 "z = {:+.1f} (virial), {:+.1f} (rate)  {}\n",
                                 row.point.packing_fraction, row.point.count,
                                 with_error(row.compressibility()), row.theory(),
                                 row.virial_judged.z, row.rate_judged.z, name_of(row.verdict()));
    }
    Verdict const verdict = together(verdicts);
    experiment.write(csv_of(rows));
    experiment.write(curves(), "_theory");
    experiment.write(macros_of(rows, experiment.profile(), verdict));
    experiment.write_table(table_of(rows));
    return verdict;
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask,
                                  clack::validation::Processes::one_a_state_point);
}
