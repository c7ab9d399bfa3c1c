// Does a second thread that reads ahead leave every bit alone, and how much sooner is a run done?

#include "simulation/engine.hpp"
#include "validation/harness/experiment.hpp"
#include "validation/harness/lattice_start.hpp"
#include "validation/harness/processor_time.hpp"
#include "validation/harness/ratio.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>

namespace clack::validation {

Question const question{
    "two_threads",
    "Does a second thread that reads ahead leave every bit alone, and how much sooner is a run "
    "done?",
    "none",
    "one hash over the collision sequence with one thread and with two; how much sooner is "
    "reported and not judged, since it is the machine's as much as the engine's"};

namespace {

struct Point {
    std::int64_t count;
    double packing_fraction;

    std::string text() const {
        return fmt::format("count={} packing_fraction={}", count, packing_fraction);
    }
    System system() const {
        System made;
        made.boundary = Boundary::periodic;
        made.count = count;
        made.side =
            std::cbrt(static_cast<double>(count) * std::numbers::pi / (6 * packing_fraction));
        return made;
    }
};

std::vector<Point> points(Profile const profile) {
    std::vector<Point> all;
    std::vector<std::int64_t> const counts =
        profile == Profile::quick ? std::vector<std::int64_t>{100'000}
                                  : std::vector<std::int64_t>{100'000, 256'000, 1'000'000};
    for (std::int64_t const count : counts)
        for (double const packing_fraction : {0.05, 0.2, 0.49})
            all.push_back({count, packing_fraction});
    return all;
}

/// Seconds of the thread that runs the events, a collision, with one and with two; and whether
/// both went the same way (1) or not (0). They take turns, so that a machine that slows down slows
/// both; the first turn, from the lattice, is not timed.
Measurement measure(Point const& point, std::uint64_t const seed) {
    constexpr int turns = 4;
    std::uint64_t const slice = static_cast<std::uint64_t>(point.count) / 2;
    System const system = point.system();
    std::array<std::unique_ptr<Engine>, 2> engines;
    for (auto& engine : engines) {
        engine = make_engine(system, Method::fast, Precision::double_, lattice_start(system, seed));
        engine->hash_collisions();
    }
    engines[1]->read_ahead();
    std::array<double, 2> seconds{};
    for (std::uint64_t turn = 1; turn <= turns; ++turn) {
        for (std::size_t k = 0; k < engines.size(); ++k) {
            double const begin = processor_seconds();
            engines[k]->advance({.ball_collisions = turn * slice});
            if (turn > 1) seconds[k] += processor_seconds() - begin;
        }
    }
    double const timed = static_cast<double>((turns - 1) * slice);
    bool const same = engines[0]->hash() == engines[1]->hash() && engines[1]->threads() == 2;
    return {seconds[0] / timed, seconds[1] / timed, same ? 1.0 : 0.0};
}

struct Found {
    Point point;
    Estimate one, two, factor; // collisions a second of each; of replicate by replicate
    bool same;
};

Found found_at(Point const& point, int const replicates, Campaign& campaign) {
    std::vector<double> one, two, factor;
    bool same = true;
    for (Measurement const& run :
         campaign.replicates(point.text(), replicates,
                             [&](std::uint64_t const seed) { return measure(point, seed); })) {
        one.push_back(1 / run[0]);
        two.push_back(1 / run[1]);
        factor.push_back(run[0] / run[1]);
        same &= run[2] == 1;
    }
    return {point, median_of(one), median_of(two), median_of(factor), same};
}

Csv csv_of(std::vector<Found> const& all) {
    Csv csv({"count", "packing_fraction", "rate_per_s", "rate_of_two_threads_per_s", "factor",
             "factor_error", "same_bits"});
    for (Found const& found : all)
        csv.row({cell(found.point.count), cell(found.point.packing_fraction), cell(found.one.value),
                 cell(found.two.value), cell(found.factor.value), cell(found.factor.error),
                 found.same ? "yes" : "no"});
    return csv;
}

std::string table_of(std::vector<Found> const& all) {
    std::vector<std::vector<std::string>> rows;
    for (Found const& found : all)
        rows.push_back({cell(found.point.count), fmt::format("{:g}", found.point.packing_fraction),
                        fmt::format("{:.2f}", 1e-6 * found.one.value),
                        fmt::format("{:.2f}", 1e-6 * found.two.value), with_error(found.factor)});
    return tabular("rrrrr", {"$n$", "$\\eta$", "one thread", "two threads", "times as fast"}, rows);
}

} // namespace

Verdict ask(Experiment& experiment) {
    constexpr int replicates = 3;
    std::vector<Found> all;
    std::vector<double> factors;
    Verdict verdict = Verdict::agrees;
    for (Point const& point : points(experiment.profile())) {
        Found const found = found_at(point, replicates, experiment.campaign());
        if (!found.same) verdict = Verdict::differs;
        factors.push_back(found.factor.value);
        std::cout << fmt::format("{:7} balls at {:<4g}: {} times as fast, {}\n", point.count,
                                 point.packing_fraction, with_error(found.factor),
                                 found.same ? "the same bits" : "other bits");
        all.push_back(found);
    }
    experiment.write(csv_of(all));
    experiment.write_table(table_of(all));
    Macros macros("TwoThreads");
    auto const [least, most] = std::minmax_element(factors.begin(), factors.end());
    macros.define("Least", significant(*least, 2));
    macros.define("Most", significant(*most, 2));
    macros.define("Replicates", fmt::format("{}", replicates));
    macros.define("Verdict", name_of(verdict));
    experiment.write(macros);
    return verdict;
}

} // namespace clack::validation
