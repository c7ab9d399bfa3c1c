// Does the pressure of soft elastic balls, as LAMMPS moves them, tend to the engine's and to
// theory's as they harden, and do they act as hard balls of the Barker-Henderson diameter?

#include "validation/pressure_vs_lammps.hpp"

#include "validation/harness/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace clack::validation {

using namespace pressure_vs_lammps;

Question const question{
    "pressure_vs_lammps",
    "Do soft elastic balls, as LAMMPS moves them step by step, have the pressure of the engine's "
    "hard balls and of theory once they are widened to a Barker-Henderson diameter of 1?",
    "1.5 % of the collisional part Zc (full profile 0.5 %)",
    "half (a third) of what softness does to balls that are not widened, where it does least"};

namespace {

/// A state point and what was measured there.
struct Row {
    StatePoint point;
    std::vector<Measurement> replicates;

    Estimate mean(std::size_t const place) const { return mean_of(replicates, place); }
    Estimate hard() const { return mean(0); }
    Estimate soft(std::size_t const stiffness) const {
        return hardened(point, replicates, stiffness);
    }
};

std::vector<Row> measured(Experiment& experiment) {
    std::string const deck = reference::lammps_deck("lammps_periodic.in");
    std::vector<Row> rows;
    for (StatePoint const& point : state_points(experiment.profile()))
        rows.push_back({point, experiment.campaign().replicates(
                                   point.text(deck), point.replicates, [&](std::uint64_t seed) {
                                       return measure(point, seed, deck);
                                   })});
    return rows;
}

Csv csv_of(std::vector<Row> const& rows, Profile const profile) {
    Csv csv({"packing_fraction", "count", "stiffness", "Z_plain", "Z_plain_error", "kT_plain",
             "Z_plain_theory", "Z_widened", "Z_widened_error", "kT_widened", "Z_hardened",
             "Z_hardened_error", "Z_clack", "Z_clack_error", "Z_theory", "margin"});
    for (Row const& row : rows) {
        for (std::size_t k = 0; k < row.point.stiffnesses.size(); ++k) {
            double const stiffness = row.point.stiffnesses[k];
            std::size_t const plain = place_of(k, Width::plain), wide = place_of(k, Width::widened);
            Estimate const hardened_z = row.soft(k);
            double const kt = row.mean(plain + 1).value;
            csv.row({cell(row.point.packing_fraction), cell(row.point.count), cell(stiffness),
                     cell(row.mean(plain).value), cell(row.mean(plain).error), cell(kt),
                     cell(softened_theory(row.point, 1, stiffness, kt)), cell(row.mean(wide).value),
                     cell(row.mean(wide).error), cell(row.mean(wide + 1).value),
                     cell(hardened_z.value), cell(hardened_z.error), cell(row.hard().value),
                     cell(row.hard().error), cell(row.point.theory()),
                     cell(margin(profile) * (row.point.theory() - 1))});
        }
    }
    return csv;
}

std::string table_of(std::vector<Row> const& rows, Ledger const& ledger) {
    std::vector<std::vector<std::string>> cells;
    for (Row const& row : rows) {
        for (std::size_t k = 0; k < row.point.stiffnesses.size(); ++k) {
            std::vector<std::string> const state{cell(row.point.packing_fraction),
                                                 cell(row.point.stiffnesses[k])};
            auto const& all = ledger.entries();
            auto const judged = std::find_if(
                all.begin(), all.end(), [&](Entry const& entry) { return entry.state == state; });
            std::vector<std::string> cells_of_row{
                fmt::format("{:.1f}", row.point.packing_fraction),
                significant(row.point.stiffnesses[k], 2),
                with_error(row.mean(place_of(k, Width::plain))),
                with_error(row.soft(k)),
                with_error(row.hard()),
                fmt::format("{:.4f}", row.point.theory()),
                judged == all.end() ? "" : fmt::format("${:+.1f}$", judged->z),
                judged == all.end() ? "(soft)" : name_of(ledger.verdict_at(state))};
            cells.push_back(cells_of_row);
        }
    }
    return tabular(
        "rrrrrrrl",
        {"$\\eta$", "$k$", "$Z$ plain", "$Z$ widened", "$Z$ clack", "$Z$ theory", "$z$", "verdict"},
        cells);
}

Macros macros_of(std::vector<Row> const& rows, Profile const profile) {
    double deviation = 0, plain = 0;
    for (Row const& row : rows) {
        double const theory = row.point.theory();
        for (std::size_t k = row.point.first_judged; k < row.point.stiffnesses.size(); ++k) {
            deviation = std::max(deviation, std::abs(row.soft(k).value / theory - 1));
            plain =
                std::max(plain, std::abs(row.mean(place_of(k, Width::plain)).value / theory - 1));
        }
    }
    Macros macros("PressureVsLammps");
    macros.define("Balls", cell(rows.front().point.count));
    macros.define("Softest", significant(rows.front().point.stiffnesses.front(), 1));
    macros.define("SoftestJudged",
                  significant(rows.front().point.stiffnesses[rows.front().point.first_judged], 1));
    macros.define("Hardest", significant(rows.front().point.stiffnesses.back(), 2));
    macros.define("LargestDeviationPercent", significant(100 * deviation, 2));
    macros.define("LargestPlainPercent", significant(100 * plain, 2));
    macros.define("MarginPercent", significant(100 * margin(profile), 2));
    return macros;
}

} // namespace

Verdict ask(Experiment& experiment) {
    std::vector<Row> const rows = measured(experiment);
    Profile const profile = experiment.profile();
    Ledger ledger({{"packing_fraction", "$\\eta$"}, {"stiffness", "$k$"}});
    for (Row const& row : rows) enter(ledger, row.point, row.replicates, margin(profile));
    Verdict const verdict = conclude(experiment, ledger, macros_of(rows, profile), risks);
    experiment.write(csv_of(rows, profile), "_values");
    experiment.write_table(table_of(rows, ledger));
    return verdict;
}

} // namespace clack::validation
