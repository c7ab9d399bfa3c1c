// How many collisions a second does each method make, where does the time go, and is the fast
// method the fastest?

#include "validation/harness/experiment.hpp"
#include "validation/speed_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace clack::validation {

using namespace speed;
using clack::validation::name_of;
using speed::name_of;

Question const question{
    "speed", "Is the fast method nowhere slower than the table and the heap, and how fast is it?",
    "0.9 times the collisions per second of each",
    "ratios on a shared machine wander by so much; the aims (5 times the heap from 4000 balls on, "
    "walls within a tenth of periodic, a cost that grows 2.5-fold at most) are reported and not "
    "judged"};

namespace {

/// What is measured of one state point, from the campaign as far as it has it.
Found found_at(Point const& point, int const replicates, Experiment& experiment) {
    std::string const peer_command = peer_of_environment();
    std::string with_peer = peer_command.empty() ? "" : " peer=" + peer_command;
    std::replace(with_peer.begin(), with_peer.end(), '|', ' '); // which ends a state point's text
    auto const measurements = experiment.campaign().replicates(
        point.text() + with_peer, replicates,
        [&](std::uint64_t const seed) { return flat(measure(point, seed, peer_command)); });
    Found found{point, {}};
    for (Measurement const& replicate : measurements)
        found.replicates.push_back(costs_of(replicate));
    return found;
}

std::vector<Found> measured(Plan const& plan, Experiment& experiment) {
    auto const points = plan.points();
    std::vector<Found> all(points.size());
    auto const measure = [&](std::size_t const k, int const times) {
        all[k] = found_at(points[k], times * plan.replicates, experiment);
    };
    measure_until_decided(points.size(), measure, [&] {
        auto const targets = targets_of(all);
        std::vector<bool> open;
        for (Point const& point : points) open.push_back(is_undecided(point, targets));
        return open;
    });
    return all;
}

Csv csv_of(std::vector<Found> const& all, double const frequency) {
    std::vector<std::string> columns{
        "boundary",         "count",     "packing_fraction", "method",         "rate_per_s",
        "rate_error_per_s", "over_heap", "over_heap_error",  "bytes_per_ball", "cycles"};
    for (char const* const part : part_names) columns.push_back(std::string("cycles_") + part);
    Csv csv(columns);
    for (Found const& found : all) {
        for (std::size_t b = 0; b < boundaries.size(); ++b) {
            for (std::size_t r = 0; r < runners.size(); ++r) {
                if (!found.has(b, r)) continue;
                Estimate const rate = found.rate(b, r), faster = found.over(b, r, b, heap);
                double const cycles = frequency / rate.value;
                std::vector<std::string> cells{name_of(boundaries[b]),
                                               cell(found.point.count),
                                               cell(found.point.packing_fraction),
                                               runners[r],
                                               cell(rate.value),
                                               cell(rate.error),
                                               cell(faster.value),
                                               cell(faster.error),
                                               cell(found.bytes(b, r)),
                                               cell(cycles)};
                for (std::size_t part = 0; part < part_count; ++part)
                    cells.push_back(cell(cycles * found.share(b, r, part)));
                csv.row(cells);
            }
        }
    }
    return csv;
}

Csv csv_of(std::vector<Target> const& targets) {
    Csv csv({"fast_over", "boundary", "count", "packing_fraction", "factor", "factor_error",
             "least", "verdict"});
    for (Target const& target : targets)
        csv.row({name_of(target.yardstick), name_of(boundaries[target.boundary]),
                 cell(target.point.count), cell(target.point.packing_fraction),
                 cell(target.factor.value), cell(target.factor.error),
                 cell(least_of(target.yardstick)), name_of(target.verdict)});
    return csv;
}

/// Where the cycles of a collision go, heap and fast beside each other, among `not_small` balls.
std::string table_of(std::vector<Found> const& all, double const frequency) {
    std::vector<std::vector<std::string>> rows;
    for (Found const& found : all) {
        if (found.point.count != not_small) continue;
        for (std::size_t const method : {heap, fast}) {
            double const cycles = frequency / found.rate(in_periodic, method).value;
            std::vector<std::string> row{
                method == heap ? fmt::format("{:g}", found.point.packing_fraction) : "",
                fmt::format("\\texttt{{{}}}", runners[method])};
            for (std::size_t part = 0; part < part_count; ++part)
                row.push_back(
                    fmt::format("{:.0f}", cycles * found.share(in_periodic, method, part)));
            row.push_back(fmt::format("{:.0f}", cycles));
            row.push_back(fmt::format("{:.0f}", found.bytes(in_periodic, method)));
            rows.push_back(row);
        }
    }
    std::vector<std::string> head{"$\\eta$", "method"};
    head.insert(head.end(), part_names.begin(), part_names.end());
    head.insert(head.end(), {"sum", "B/ball"});
    return tabular("rlrrrrrrr", head, rows);
}

Macros macros_of(std::vector<Found> const& all, std::vector<Target> const& targets,
                 Profile const profile, Verdict const verdict) {
    Macros macros("Speed");
    macros.define("Profile", name_of(profile));
    macros.define("Verdict", name_of(verdict));
    macros.define("Replicates", fmt::format("{}", all.front().replicates.size()));
    macros.define("SmallestCount", fmt::format("{}", all.front().point.count));
    macros.define("LargestCount", fmt::format("{}", all.back().point.count));
    macros.define("NotSmall", fmt::format("{}", not_small));
    macros.define("Aim", fmt::format("{}", over_heap));
    macros.define("GrowthAim", fmt::format("{}", growth_max));
    std::vector<double> heaps, walls, grown, rates;
    int reached = 0;
    for (Target const& target : targets) {
        if (target.yardstick == Yardstick::five_heaps) {
            heaps.push_back(target.factor.value);
            reached += target.verdict == Verdict::agrees;
        }
        if (target.yardstick == Yardstick::periodic) walls.push_back(target.factor.value);
        if (target.yardstick == Yardstick::fewer_balls) grown.push_back(1 / target.factor.value);
    }
    for (Found const& found : all) rates.push_back(found.rate(in_periodic, fast).value);
    auto const define_range = [&](std::string const& name, std::vector<double> const& values) {
        auto const [least, most] = std::minmax_element(values.begin(), values.end());
        macros.define(name + "Least", significant(*least, 2));
        macros.define(name + "Most", significant(*most, 2));
    };
    define_range("OverHeap", heaps);
    define_range("WallsOverPeriodic", walls);
    define_range("Growth", grown);
    for (double& rate : rates) rate *= 1e-6;
    define_range("MillionsPerSecond", rates);
    macros.define("AimPoints", fmt::format("{}", heaps.size()));
    macros.define("AimReached", fmt::format("{}", reached));
    return macros;
}

/// Reached or not, of an aim; the verdict, of what is judged.
std::string state_of(Target const& target) {
    if (is_judged(target.yardstick)) return name_of(target.verdict);
    return target.verdict == Verdict::agrees    ? "reached"
           : target.verdict == Verdict::differs ? "missed"
                                                : "undecided";
}

/// One line a state point: rates in millions a second, over the heap's, and how that is judged.
void print(Found const& found, std::size_t const b, std::vector<Target> const& targets) {
    std::cout << fmt::format("{:8} {:7} balls at {:<4g}:", name_of(boundaries[b]),
                             found.point.count, found.point.packing_fraction);
    for (std::size_t r = 0; r < runners.size(); ++r) {
        if (!found.has(b, r)) continue;
        std::cout << fmt::format("  {} {:.3f}", runners[r], 1e-6 * found.rate(b, r).value);
        if (r != heap)
            std::cout << fmt::format(" = {} heaps", with_error(found.over(b, r, b, heap)));
    }
    std::string separator = "  ";
    for (Target const& target : targets) {
        if (target.boundary != b || target.point.text() != found.point.text() ||
            target.yardstick > Yardstick::five_heaps)
            continue;
        std::cout << separator << name_of(target.yardstick) << ' ' << state_of(target);
        separator = ", ";
    }
    std::cout << '\n';
}

/// The other aims, one line each.
void print(Target const& target) {
    std::cout << fmt::format("{:8} {:7} balls at {:<4g}: {} of the rate {}, at least {:g}: {}\n",
                             name_of(boundaries[target.boundary]), target.point.count,
                             target.point.packing_fraction, with_error(target.factor),
                             name_of(target.yardstick), least_of(target.yardstick),
                             state_of(target));
}

void print(std::vector<Found> const& all, std::vector<Target> const& targets) {
    std::cout << "fast over the others, and in millions of collisions per second:\n";
    for (Found const& found : all)
        for (std::size_t b = 0; b < boundaries.size(); ++b) print(found, b, targets);
    for (Yardstick const yardstick : {Yardstick::periodic, Yardstick::fewer_balls})
        for (Target const& target : targets)
            if (target.yardstick == yardstick) print(target);
}

} // namespace

Verdict ask(Experiment& experiment) {
    std::vector<Found> const all = measured(plan(experiment.profile()), experiment);
    std::vector<Target> const targets = targets_of(all);
    std::vector<Verdict> verdicts;
    for (Target const& target : targets)
        if (is_judged(target.yardstick)) verdicts.push_back(target.verdict);
    Verdict const verdict = together(verdicts);
    double const frequency = cycles_per_second();
    print(all, targets);
    experiment.write(csv_of(all, frequency));
    experiment.write(csv_of(targets), "_targets");
    experiment.write_table(table_of(all, frequency));
    experiment.write(macros_of(all, targets, experiment.profile(), verdict));
    return verdict;
}

} // namespace clack::validation
