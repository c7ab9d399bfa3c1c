// Does the cost grow with the number of balls as the report of 2015 says, and what do cells save?

#include "validation/complexity.hpp"

#include "validation/harness/ledger.hpp"

#include <fmt/format.h>

#include <cctype>

namespace clack::validation {

using namespace complexity;

Question const question{
    "complexity",
    "Does the report's table cost O(n^2) to start and O(n) a collision, and do cells cost O(n) to "
    "start and the same a collision at every n?",
    "0.4 in the exponent",
    "below half the distance of the integers in question it belongs to one of them alone, and the "
    "caches have room"};

namespace {

constexpr std::array all_work{Work::start, Work::collision};

char const* name_of(Work const quantity) { return quantity == Work::start ? "start" : "collision"; }

/// A method's start or collision with all that was found out about it.
struct Row {
    std::size_t ladder;
    Work quantity;
    Comparison exponent;
    std::vector<Estimate> costs; // mean over the sweeps, smallest size first
    Power power;                 // fitted to them
};

std::vector<Row> measured(Plan const& plan, Experiment& experiment) {
    auto const sweeps = experiment.campaign().replicates(
        plan.text(), plan.replicates,
        [&](std::uint64_t const seed) { return measure(plan, seed); });
    std::vector<Row> rows;
    for (std::size_t ladder = 0; ladder < plan.ladders.size(); ++ladder) {
        auto const& counts = plan.counts(plan.ladders[ladder].largest);
        for (Work const quantity : all_work) {
            Row row{ladder, quantity, compare(plan, ladder, quantity, sweeps), {}, {}};
            std::vector<double> means;
            for (std::size_t k = 0; k < counts.size(); ++k) {
                row.costs.push_back(mean_of(sweeps, [&](Measurement const& sweep) {
                    return costs_of(plan, ladder, quantity, sweep)[k];
                }));
                means.push_back(row.costs.back().value);
            }
            row.power = fit_power(plan.counts(plan.largest_fitted), means);
            rows.push_back(row);
        }
    }
    return rows;
}

Csv csv_of(Plan const& plan, std::vector<Row> const& rows) {
    Csv csv({"method", "quantity", "count", "cpu_seconds", "cpu_seconds_error", "cpu_seconds_fit",
             "exponent", "exponent_error", "exponent_expected"});
    for (Row const& row : rows) {
        Ladder const& ladder = plan.ladders[row.ladder];
        auto const counts = plan.counts(ladder.largest);
        for (std::size_t k = 0; k < counts.size(); ++k)
            csv.row({name_of(ladder.method), name_of(row.quantity), cell(counts[k]),
                     cell(row.costs[k].value), cell(row.costs[k].error),
                     cell(row.power.at(static_cast<double>(counts[k]))),
                     cell(row.exponent.measured.value), cell(row.exponent.measured.error),
                     cell(row.exponent.reference)});
    }
    return csv;
}

std::string capitalised(std::string word) {
    word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
    return word;
}

Macros macros_of(Plan const& plan, std::vector<Row> const& rows) {
    Macros macros("Complexity");
    macros.define("PackingFraction", fmt::format("{}", plan.packing_fraction));
    macros.define("Sweeps", fmt::format("{}", plan.replicates));
    macros.define("LargestFittedCount", fmt::format("{}", plan.largest_fitted));
    macros.define("Margin", fmt::format("{}", margin));
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

} // namespace

Verdict ask(Experiment& experiment) {
    Plan const sizes = plan(experiment.profile());
    std::vector<Row> const rows = measured(sizes, experiment);
    Ledger ledger({{"method", "method"}, {"of_a", "of a"}});
    for (Row const& row : rows)
        ledger.compare({name_of(sizes.ladders[row.ladder].method), name_of(row.quantity)},
                       {"exponent", "exponent"}, row.exponent);
    experiment.write(csv_of(sizes, rows), "_costs");
    return conclude(experiment, ledger, macros_of(sizes, rows), of_timing);
}

} // namespace clack::validation
