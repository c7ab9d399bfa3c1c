// Does a second thread that reads ahead leave every bit alone, and how much sooner is a run done?

#include "validation/harness/ledger.hpp"
#include "validation/lattice_start.hpp"
#include "validation/timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace clack::validation {

Question const question{
    "two_threads",
    "Does a second thread that reads ahead leave every bit alone, and how much sooner is a run "
    "done?",
    "none",
    "one hash over the collision sequence with one thread and with two; how much sooner is "
    "reported and not judged, since it is the machine's as much as the engine's"};

namespace {

/// How many times as long one thread takes as two, and whether both went the same way (1) or not
/// (0). They take turns, so that a machine that slows down slows both; the first turn, from the
/// lattice, does not count.
Measurement measure(System const& system, std::uint64_t const seed) {
    constexpr int turns = 3;
    std::array<TimedRun, 2> runs;
    for (TimedRun& run : runs) {
        run.engine =
            make_engine(system, Method::fast, Precision::double_, lattice_start(system, seed));
        run.engine->hash_collisions();
    }
    runs[1].engine->read_ahead();
    std::array<double, 2> seconds{};
    for (int turn = 0; turn < turns; ++turn) {
        for (std::size_t k = 0; k < runs.size(); ++k) {
            double const taken = runs[k].go(static_cast<std::uint64_t>(system.count) / 2);
            if (turn > 0) seconds[k] += taken;
        }
    }
    bool const same = runs[0].engine->hash() == runs[1].engine->hash();
    return {seconds[0] / seconds[1], same && runs[1].engine->threads() == 2 ? 1.0 : 0.0};
}

} // namespace

Verdict ask(Experiment& experiment) {
    constexpr int replicates = 3;
    std::vector<std::int64_t> counts{100'000};
    if (experiment.profile() == Profile::full) counts.insert(counts.end(), {256'000, 1'000'000});
    Ledger ledger({{"count", "$n$"}, {"packing_fraction", "$\\eta$"}});
    std::vector<double> factors;
    for (std::int64_t const count : counts) {
        for (double const packing_fraction : {0.05, 0.2, 0.49}) {
            auto const measured = experiment.campaign().replicates(
                fmt::format("count={} packing_fraction={}", count, packing_fraction), replicates,
                [=](std::uint64_t const seed) {
                    return measure(cube(Boundary::periodic, count, packing_fraction), seed);
                });
            std::vector<std::string> const state{cell(count), fmt::format("{}", packing_fraction)};
            ledger.bound(state, {"same_bits", "runs with the same bits"},
                         mean_of(measured, 1).value, 1, 0);
            Estimate const factor =
                median_of(measured, [](Measurement const& run) { return run[0]; });
            ledger.guide(state, {"times_as_fast", "times as fast"},
                         {.measured = factor, .reference = 1});
            factors.push_back(factor.value);
        }
    }
    Macros macros("TwoThreads");
    macros.define("Least", significant(std::ranges::min(factors), 2));
    macros.define("Most", significant(std::ranges::max(factors), 2));
    macros.define("Replicates", cell(replicates));
    return conclude(experiment, ledger, macros);
}

} // namespace clack::validation
