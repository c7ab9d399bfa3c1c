// Does the cost grow with the number of balls as the report of 2015 says, and what do cells save?

#include "validation/complexity.hpp"

#include "validation/harness/experiment.hpp"

#include <fmt/format.h>

#include <cctype>
#include <iostream>

namespace clack::validation {

namespace {

using namespace complexity;

Question const question{
    "complexity",
    "Does the report's table cost O(n^2) to start and O(n) a collision, and do cells cost O(n) to "
    "start and the same a collision at every n?",
    "0.4 in the exponent",
    "below half the distance of the integers in question it belongs to one of them alone, and the "
    "caches have room"};

constexpr std::array quantities{Quantity::start, Quantity::collision};

char const* name_of(Quantity const quantity) {
    return quantity == Quantity::start ? "start" : "collision";
}

/// A method's start or collision with all that was found out about it.
struct Row {
    std::size_t ladder;
    Quantity quantity;
    Comparison exponent;
    Judgement judged;
    std::vector<Estimate> costs; // mean over the sweeps, smallest size first
    Power power;                 // fitted to them
};

std::vector<Row> measured(Plan const& plan, Experiment& experiment) {
    auto const sweeps = experiment.campaign().replicates(
        plan.text(), plan.replicates,
        [&](std::uint64_t const seed) { return measure(plan, seed); });
    std::vector<Row> rows;
    std::vector<Comparison> comparisons;
    for (std::size_t ladder = 0; ladder < plan.ladders.size(); ++ladder) {
        auto const& counts = plan.counts(plan.ladders[ladder].largest);
        for (Quantity const quantity : quantities) {
            Row row{ladder, quantity, compare(plan, ladder, quantity, sweeps), {}, {}, {}};
            std::vector<std::vector<double>> by_size(counts.size());
            for (Measurement const& sweep : sweeps) {
                auto const costs = costs_of(plan, ladder, quantity, sweep);
                for (std::size_t k = 0; k < counts.size(); ++k) by_size[k].push_back(costs[k]);
            }
            std::vector<double> means;
            for (auto const& costs : by_size) {
                row.costs.push_back(mean_of(costs));
                means.push_back(row.costs.back().value);
            }
            row.power = fit_power(plan.counts(plan.largest_fitted), means);
            comparisons.push_back(row.exponent);
            rows.push_back(row);
        }
    }
    auto const judgements = judge(comparisons, of_timing);
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].judged = judgements[k];
    return rows;
}

Csv csv_of(Plan const& plan, std::vector<Row> const& rows) {
    Csv csv({"method", "quantity", "count", "cpu_seconds", "cpu_seconds_error", "cpu_seconds_fit",
             "exponent", "exponent_error", "exponent_expected", "verdict"});
    for (Row const& row : rows) {
        Ladder const& ladder = plan.ladders[row.ladder];
        auto const counts = plan.counts(ladder.largest);
        for (std::size_t k = 0; k < counts.size(); ++k)
            csv.row({name_of(ladder.method), name_of(row.quantity), cell(counts[k]),
                     cell(row.costs[k].value), cell(row.costs[k].error),
                     cell(row.power.at(static_cast<double>(counts[k]))),
                     cell(row.exponent.measured.value), cell(row.exponent.measured.error),
                     cell(row.exponent.reference), name_of(row.judged.verdict)});
    }
    return csv;
}

std::string table_of(Plan const& plan, std::vector<Row> const& rows) {
    std::vector<std::vector<std::string>> cells;
    for (Row const& row : rows) {
        Ladder const& ladder = plan.ladders[row.ladder];
        cells.push_back({fmt::format("\\texttt{{{}}}", name_of(ladder.method)),
                         name_of(row.quantity), with_error(row.exponent.measured),
                         fmt::format("{:.0f}", row.exponent.reference),
                         name_of(row.judged.verdict)});
    }
    return tabular("lllrl", {"method", "of a", "exponent", "expected", "verdict"}, cells);
}

std::string capitalised(std::string word) {
    word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
    return word;
}

Macros macros_of(Plan const& plan, std::vector<Row> const& rows, Profile const profile,
                 Verdict const verdict) {
    Macros macros("Complexity");
    macros.define("Profile", name_of(profile));
    macros.define("PackingFraction", fmt::format("{}", plan.packing_fraction));
    macros.define("Sweeps", fmt::format("{}", plan.replicates));
    macros.define("LargestFittedCount", fmt::format("{}", plan.largest_fitted));
    macros.define("Margin", fmt::format("{}", margin));
    macros.define("Verdict", name_of(verdict));
    for (Row const& row : rows) {
        Ladder const& ladder = plan.ladders[row.ladder];
        std::string const name =
            capitalised(name_of(ladder.method)) + capitalised(name_of(row.quantity));
        macros.define(name + "Exponent", with_error(row.exponent.measured));
        macros.define(name + "Microseconds", significant(1e6 * row.costs.back().value, 2));
        macros.define(name + "LargestCount", fmt::format("{}", ladder.largest));
    }
    // The table's largest size stands at the same place on the ladders of all methods.
    std::size_t const last = plan.counts(plan.ladders.front().largest).size() - 1;
    macros.define("TableOverFast",
                  significant(rows[1].costs[last].value / rows.back().costs[last].value, 2));
    return macros;
}

Verdict ask(Experiment& experiment) {
    Plan const sizes = plan(experiment.profile());
    std::vector<Row> const rows = measured(sizes, experiment);
    std::vector<Judgement> judgements;
    for (Row const& row : rows) {
        judgements.push_back(row.judged);
        std::cout << fmt::format(
            "{:5} {:9}: exponent {:<10} expected {:.0f}, {:.2g} us at {} balls  {}\n",
            name_of(sizes.ladders[row.ladder].method), name_of(row.quantity),
            with_error(row.exponent.measured), row.exponent.reference, 1e6 * row.costs.back().value,
            sizes.ladders[row.ladder].largest, name_of(row.judged.verdict));
    }
    Verdict const verdict = together(judgements);
    experiment.write(csv_of(sizes, rows));
    experiment.write(macros_of(sizes, rows, experiment.profile(), verdict));
    experiment.write_table(table_of(sizes, rows));
    return verdict;
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask);
}
