// Does the cost grow with the number of balls as the report of 2015 says, and what do cells save?

#include "validation/complexity.hpp"

#include "validation/harness/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace clack::validation {

using namespace complexity;

Question const question{
    "complexity",
    "Does the report's table cost O(n^2) to start and O(n) a collision, and do cells cost O(n) to "
    "start and the same a collision at every n?",
    fmt::format("{} in the exponent", margin),
    "below half the distance of the integers in question it belongs to one of them alone, and the "
    "caches have room"};

namespace {

/// A method's starts or collisions: mean over the sweeps, smallest size first, and the power of n
/// that is fitted to them.
struct Row {
    Ladder ladder;
    Work work;
    std::vector<Estimate> costs;
    Power power;
    Comparison exponent;
};

Row row_of(Plan const& plan, std::size_t const ladder, Work const work,
           std::vector<Measurement> const& sweeps) {
    Row row{plan.ladders[ladder], work, {}, {}, compare(plan, ladder, work, sweeps)};
    std::vector<double> means;
    for (std::size_t k = 0; k < plan.counts(row.ladder.largest).size(); ++k) {
        row.costs.push_back(mean_of(sweeps, [&](Measurement const& sweep) {
            return costs_of(plan, ladder, work, sweep)[k];
        }));
        means.push_back(row.costs.back().value);
    }
    row.power = fit_power(plan.counts(plan.largest_fitted), means);
    return row;
}

Csv csv_of(Plan const& plan, std::vector<Row> const& rows) {
    Csv csv({"method", "quantity", "count", "cpu_seconds", "cpu_seconds_error", "cpu_seconds_fit",
             "exponent"});
    for (Row const& row : rows) {
        auto const counts = plan.counts(row.ladder.largest);
        for (std::size_t k = 0; k < counts.size(); ++k)
            csv.row({name_of(row.ladder.method), name_of(row.work), cell(counts[k]),
                     cell(row.costs[k].value), cell(row.costs[k].error),
                     cell(row.power.at(static_cast<double>(counts[k]))),
                     cell(row.exponent.measured.value)});
    }
    return csv;
}

Macros macros_of(Plan const& plan, std::vector<Row> const& rows) {
    auto const of = [&](Method const method, Work const work) {
        return *std::find_if(rows.begin(), rows.end(), [=](Row const& row) {
            return row.ladder.method == method && row.work == work;
        });
    };
    Row const start = of(Method::table, Work::start), table = of(Method::table, Work::collision);
    Row const fast = of(Method::fast, Work::collision);
    Macros macros("Complexity");
    macros.define("PackingFraction", fmt::format("{}", plan.packing_fraction));
    macros.define("LargestFittedCount", cell(plan.largest_fitted));
    macros.define("TableStartExponent", with_error(start.exponent.measured));
    macros.define("TableCollisionExponent", with_error(table.exponent.measured));
    macros.define("FastCollisionExponent", with_error(fast.exponent.measured));
    macros.define("TableCollisionLargestCount", cell(table.ladder.largest));
    macros.define("TableCollisionMicroseconds", significant(1e6 * table.costs.back().value, 2));
    // The table's largest size stands at the same place on the ladders of all methods.
    macros.define(
        "TableOverFast",
        significant(table.costs.back().value / fast.costs[table.costs.size() - 1].value, 2));
    return macros;
}

} // namespace

Verdict ask(Experiment& experiment) {
    Plan const plan = complexity::plan(experiment.profile());
    auto const sweeps = experiment.campaign().replicates(
        plan.text(), plan.replicates,
        [&](std::uint64_t const seed) { return measure(plan, seed); });
    std::vector<Row> rows;
    Ledger ledger({{"method", "method"}, {"of_a", "of a"}});
    for (std::size_t ladder = 0; ladder < plan.ladders.size(); ++ladder) {
        for (Work const work : {Work::start, Work::collision}) {
            rows.push_back(row_of(plan, ladder, work, sweeps));
            ledger.compare({name_of(plan.ladders[ladder].method), name_of(work)},
                           {"exponent", "exponent"}, rows.back().exponent);
        }
    }
    experiment.write(csv_of(plan, rows), "_costs");
    return conclude(experiment, ledger, macros_of(plan, rows), of_timing);
}

} // namespace clack::validation
