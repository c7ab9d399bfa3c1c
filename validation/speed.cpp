// How many collisions a second does each method make, where does the time go, and is the fast
// method the fastest?

#include "validation/speed_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace clack::validation {

using namespace speed;

Question const question{
    "speed", "Is the fast method nowhere slower than the table and the heap, and how fast is it?",
    fmt::format("{} times the collisions per second of each", least),
    "ratios on a shared machine wander by so much; the aims (5 times the heap from 4000 balls on, "
    "walls within a tenth of periodic, a cost that grows 2.5-fold at most) are reported and not "
    "judged"};

namespace {

/// Of a collision.
std::vector<std::string> cycles_of(Found const& found, std::size_t const b, std::size_t const r) {
    static double const frequency = cycles_per_second();
    double const cycles = frequency / found.rate(b, r).value;
    std::vector<std::string> cells{fmt::format("{:.0f}", cycles)};
    for (std::size_t part = first_part; part < value_count; ++part)
        cells.push_back(fmt::format("{:.0f}", cycles * found.mean(b, r, part)));
    return cells;
}

Csv rates_of(std::vector<Found> const& all) {
    std::vector<std::string> columns{
        "boundary",         "count",     "packing_fraction", "method",         "rate_per_s",
        "rate_error_per_s", "over_heap", "over_heap_error",  "bytes_per_ball", "cycles"};
    for (char const* const part : part_names) columns.push_back(std::string("cycles_") + part);
    Csv csv(columns);
    for (Found const& found : all)
        for (std::size_t b = 0; b < boundaries.size(); ++b)
            for (std::size_t r = 0; r < runners.size(); ++r) {
                if (!found.has(b, r)) continue;
                Estimate const rate = found.rate(b, r), faster = found.over(b, r, b, heap);
                auto cells = found.state(b);
                cells.insert(cells.end(),
                             {runners[r], cell(rate.value), cell(rate.error), cell(faster.value),
                              cell(faster.error), cell(found.mean(b, r, bytes))});
                std::ranges::copy(cycles_of(found, b, r), std::back_inserter(cells));
                csv.row(cells);
            }
    return csv;
}

/// Where the cycles of a collision go, heap and fast beside each other, among `not_small` balls.
std::string parts_of(std::vector<Found> const& all) {
    std::vector<std::vector<std::string>> rows;
    for (Found const& found : all) {
        if (found.point.count != not_small) continue;
        for (std::size_t const method : {heap, fast}) {
            rows.push_back({fmt::format("{:g}", found.point.packing_fraction),
                            fmt::format("\\texttt{{{}}}", runners[method]),
                            fmt::format("{:.0f}", found.mean(in_periodic, method, bytes))});
            std::ranges::copy(cycles_of(found, in_periodic, method),
                              std::back_inserter(rows.back()));
        }
    }
    std::vector<std::string> head{"$\\eta$", "method", "B/ball", "all"};
    head.insert(head.end(), part_names.begin(), part_names.end());
    return tabular("rlrrrrrrr", head, rows);
}

} // namespace

Verdict ask(Experiment& experiment) {
    std::vector<Found> const all = measured(experiment);
    Ledger ledger = ledger_of(all);
    Macros macros("Speed");
    macros.define("Replicates", cell(replicates));
    macros.define("LargestCount", cell(all.back().point.count));
    macros.define("NotSmall", cell(not_small));
    macros.define("Aim", fmt::format("{}", over_heap));
    macros.define("GrowthAim", fmt::format("{}", growth_max));
    std::map<std::string, std::vector<double>> values;
    for (Entry const& entry : ledger.entries())
        values[entry.quantity.name].push_back(entry.comparison.measured.value);
    for (Found const& found : all)
        values["rate"].push_back(1e-6 * found.rate(in_periodic, fast).value);
    for (auto const& [name, quantity] : {std::pair{"OverHeap", "aim_over_heap"},
                                         {"WallsOverPeriodic", "walls_over_periodic"},
                                         {"Growth", "growth"},
                                         {"MillionsPerSecond", "rate"}}) {
        auto const [lowest, highest] = std::ranges::minmax(values[quantity]);
        macros.define(std::string(name) + "Least", significant(lowest, 2));
        macros.define(std::string(name) + "Most", significant(highest, 2));
    }
    macros.define("AimPoints", cell(values["aim_over_heap"].size()));
    macros.define("AimReached", cell(std::ranges::count_if(values["aim_over_heap"], [](double x) {
                      return x >= over_heap;
                  })));
    experiment.write(rates_of(all), "_rates");
    Verdict const verdict = conclude(experiment, ledger, macros, of_timing);
    experiment.write_table(parts_of(all)); // the account would fill pages
    return verdict;
}

} // namespace clack::validation
