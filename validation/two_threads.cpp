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

namespace {

Question const question{
    "two_threads",
    "Does a second thread that reads ahead leave every bit alone, and how much sooner is a run "
    "done?",
    "none",
    "one hash over the collision sequence with one thread and with two; how much sooner is "
    "reported and not judged, since it is the machine's as much as the engine's"};

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

Verdict ask(Experiment& experiment) {
    constexpr int replicates = 3;
    Csv csv({"count", "packing_fraction", "rate_per_s", "rate_of_two_threads_per_s", "factor",
             "factor_error", "same_bits"});
    std::vector<std::vector<std::string>> rows;
    std::vector<double> factors;
    Verdict verdict = Verdict::agrees;
    for (Point const& point : points(experiment.profile())) {
        std::vector<double> one, two, factor;
        bool same = true;
        for (Measurement const& run : experiment.campaign().replicates(
                 point.text(), replicates,
                 [&](std::uint64_t const seed) { return measure(point, seed); })) {
            one.push_back(1 / run[0]);
            two.push_back(1 / run[1]);
            factor.push_back(run[0] / run[1]);
            same &= run[2] == 1;
        }
        if (!same) verdict = Verdict::differs;
        Estimate const faster = median_of(factor);
        factors.push_back(faster.value);
        csv.row({cell(point.count), cell(point.packing_fraction), cell(median_of(one).value),
                 cell(median_of(two).value), cell(faster.value), cell(faster.error),
                 same ? "yes" : "no"});
        rows.push_back({cell(point.count), fmt::format("{:g}", point.packing_fraction),
                        fmt::format("{:.2f}", 1e-6 * median_of(one).value),
                        fmt::format("{:.2f}", 1e-6 * median_of(two).value), with_error(faster)});
        std::cout << fmt::format("{:7} balls at {:<4g}: {} times as fast, {}\n", point.count,
                                 point.packing_fraction, with_error(faster),
                                 same ? "the same bits" : "OTHER BITS");
    }
    experiment.write(csv);
    experiment.write_table(
        tabular("rrrrr", {"$n$", "$\\eta$", "one thread", "two threads", "times as fast"}, rows));
    Macros macros("TwoThreads");
    auto const [least, most] = std::minmax_element(factors.begin(), factors.end());
    macros.define("Least", significant(*least, 2));
    macros.define("Most", significant(*most, 2));
    macros.define("Replicates", fmt::format("{}", replicates));
    macros.define("Verdict", name_of(verdict));
    experiment.write(macros);
    return verdict;
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask);
}
