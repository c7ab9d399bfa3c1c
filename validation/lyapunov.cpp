// How fast do two runs that begin nearly alike part, and does tangent space say the same as twins?

#include "validation/lyapunov.hpp"

#include "validation/harness/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace clack::validation {

using namespace lyapunov;

Question const question{
    "lyapunov",
    "How fast does a small error grow, by the collisions of a ball, over packing fraction and "
    "number; do tangent space and twin runs agree on it; and does the program's formula hold where "
    "it was not fitted?",
    "twins against the tangent vector along the same run: 0.1 %; the formula against tangent "
    "space: 6 %",
    "beyond what quad rounds and what curves at the last distance, and far less than a wrong term "
    "would change; at numbers and packing fractions that it was not fitted to, two collisions per "
    "ball of a horizon of thirty"};

namespace {

constexpr double twin_margin = 1e-3, formula_margin = 0.06;

/// A state point with what was measured there, in the order of a Measurement.
struct Row {
    StatePoint point;
    std::vector<Estimate> measured;
    Comparison comparison;
    Judgement judged{};

    bool is_judged() const { return !measured.empty() && point.part == Part::held_out; }
    double off() const { return std::abs(measured[0].value / comparison.reference - 1); }
    std::string name() const {
        return fmt::format("{} packing fraction {} count {}", point.boundary_name(),
                           point.packing_fraction, point.count);
    }
};

std::vector<double> column(std::vector<Measurement> const& replicates, std::size_t const place) {
    std::vector<double> values;
    for (Measurement const& replicate : replicates) values.push_back(replicate[place]);
    return values;
}

/// Exponents from tangent space beside the formula.
std::vector<Row> tangent_rows(Experiment& experiment) {
    std::vector<Row> rows;
    for (StatePoint const& point : state_points(experiment.profile())) {
        auto const replicates = experiment.campaign().replicates(
            point.text("tangent"), point.replicates,
            [&](std::uint64_t const seed) { return measure(point, seed); });
        Estimate const exponent = mean_of(column(replicates, 0));
        double const formula = reference::lyapunov_exponent_per_collision(point.system());
        rows.push_back({point, {exponent}, {}});
        rows.back().comparison = {rows.back().name(), exponent, formula, 0,
                                  formula_margin * formula};
    }
    return rows;
}

/// Exponents from twin runs beside those of the tangent vector on the same way.
std::vector<Row> twin_rows(Experiment& experiment) {
    std::vector<Row> rows;
    for (StatePoint const& point : twin_points(experiment.profile())) {
        auto const replicates = experiment.campaign().replicates(
            point.text("twins"), point.replicates,
            [&](std::uint64_t const seed) { return measure_twins(point, seed); });
        std::vector<double> ratios;
        for (Measurement const& replicate : replicates)
            ratios.push_back(replicate[0] / replicate[1]);
        rows.push_back(
            {point, {mean_of(column(replicates, 0)), mean_of(column(replicates, 1))}, {}});
        rows.back().comparison = {"twins " + rows.back().name(), mean_of(ratios), 1, 0,
                                  twin_margin};
    }
    return rows;
}

char const* verdict_of(Row const& row) {
    return row.is_judged() ? name_of(row.judged.verdict) : "fitted";
}

Csv csv_of(std::vector<Row> const& rows) {
    Csv csv({"boundary", "packing_fraction", "count", "exponent_per_collision",
             "exponent_per_collision_error", "formula", "z", "verdict"});
    for (Row const& row : rows)
        csv.row({row.point.boundary_name(), cell(row.point.packing_fraction), cell(row.point.count),
                 cell(row.measured[0].value), cell(row.measured[0].error),
                 cell(row.comparison.reference), cell(row.judged.z), verdict_of(row)});
    return csv;
}

Csv twins_csv_of(std::vector<Row> const& rows) {
    Csv csv({"boundary", "packing_fraction", "count", "exponent_per_collision",
             "exponent_per_collision_error", "twins_over_tangent", "twins_over_tangent_error",
             "verdict"});
    for (Row const& row : rows)
        csv.row({row.point.boundary_name(), cell(row.point.packing_fraction), cell(row.point.count),
                 cell(row.measured[0].value), cell(row.measured[0].error),
                 cell(row.comparison.measured.value), cell(row.comparison.measured.error),
                 name_of(row.judged.verdict)});
    return csv;
}

Macros macros_of(std::vector<Row> const& tangent, std::vector<Row> const& twins,
                 Profile const profile, Verdict const verdict) {
    double held_out = 0, fitted = 0, twin = 0;
    int points = 0;
    for (Row const& row : tangent) {
        double& worst = row.is_judged() ? held_out : fitted;
        worst = std::max(worst, row.off());
        points += row.is_judged();
    }
    for (Row const& row : twins) twin = std::max(twin, std::abs(row.comparison.measured.value - 1));
    Macros macros("Lyapunov");
    macros.define("Profile", name_of(profile));
    macros.define("FormulaWorstPercent", significant(100 * held_out, 2));
    macros.define("FormulaFittedPercent", significant(100 * fitted, 2));
    macros.define("HeldOutPoints", cell(points));
    int pairs = 0;
    for (Row const& row : twins) pairs += row.point.replicates;
    macros.define("TwinPairs", cell(pairs));
    macros.define("FormulaMarginPercent", significant(100 * formula_margin, 2));
    macros.define("TwinsWorst", significant(twin, 1));
    macros.define("TwinsMarginPercent", significant(100 * twin_margin, 2));
    macros.define("Nudge", significant(Twins::nudge, 1));
    macros.define("Last", significant(Twins::last, 1));
    macros.define("Verdict", name_of(verdict));
    return macros;
}

} // namespace

Verdict ask(Experiment& experiment) {
    std::vector<Row> tangent = tangent_rows(experiment), twins = twin_rows(experiment);
    std::vector<Row*> judged;
    std::vector<Comparison> comparisons;
    for (Row& row : tangent)
        if (row.is_judged()) judged.push_back(&row);
    for (Row& row : twins) judged.push_back(&row);
    for (Row const* const row : judged) comparisons.push_back(row->comparison);
    auto const judgements = judge(comparisons);
    for (std::size_t k = 0; k < judgements.size(); ++k) {
        judged[k]->judged = judgements[k];
        Comparison const& c = comparisons[k];
        std::cout << fmt::format(
            "{}: {:.9g} +- {:.1g}, expected {:.4g} +- {:.2g}: z = {:+.1f}  {}\n", c.name,
            c.measured.value, c.measured.error, c.reference, c.margin, judgements[k].z,
            name_of(judgements[k].verdict));
    }
    Verdict const verdict = together(judgements);
    experiment.write(csv_of(tangent));
    experiment.write(twins_csv_of(twins), "_twins");
    experiment.write(macros_of(tangent, twins, experiment.profile(), verdict));
    return verdict;
}

} // namespace clack::validation
