// What does one more digit of a statistical result cost with each method, and where does its bias
// end it?

#include "validation/cost_of_statistics.hpp"

#include "validation/harness/ledger.hpp"
#include "validation/statistics/estimate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iostream>

namespace clack::validation {

using namespace cost_of_statistics;

Question const question{
    "cost_of_statistics",
    "Does the engine's error of the compressibility factor fall as the root of the processor time "
    "without end, where steps of time and soft balls stop at a bias?",
    fmt::format("slope of the error's logarithm by that of the time -1/2 +- {}; bias of the engine "
                "0 +- {} of Z",
                slope_margin, percent(bias_margin)),
    "far from the slope 0 of a bias and from the -1 of a method that integrates; a tenth of the "
    "bias of the softest balls; the biases of the others are shown"};

namespace {

/// A method with its knob: processor time and Z of all replicates, for each duration.
struct Line {
    std::string method, knob;
    std::vector<Measurement> replicates;

    std::size_t durations() const { return replicates.front().size() / 2; }
    Estimate last_z() const { return mean_of(replicates, 2 * durations() - 1); }
};

std::vector<Line> measured(Experiment& experiment, Plan const& plan) {
    std::vector<Line> lines;
    auto const add = [&](std::string const& method, std::string const& knob, int const replicates,
                         Measure const& measure) {
        std::string const text =
            fmt::format("{} {} packing_fraction={} count={} durations={} stepped={}", method, knob,
                        plan.point.packing_fraction, plan.point.count,
                        fmt::join(plan.durations, ","), plan.stepped_durations);
        Task const task{text, replicates, measure};
        lines.push_back({method, knob, experiment.campaign().replicates({task}).front()});
    };
    add("fast", "double", plan.engine_replicates,
        [&](std::uint64_t const seed) { return measure_engine(plan, seed); });
    for (double const step : plan.steps)
        add("frames", fmt::format("{:g}", step), plan.stepped_replicates,
            [&](std::uint64_t const seed) { return measure_frames(plan, step, seed); });
    try {
        std::string const deck = reference::lammps_deck("lammps_periodic.in");
        for (double const stiffness : plan.stiffnesses)
            add("lammps", fmt::format("{:g}", stiffness), plan.stepped_replicates,
                [&](std::uint64_t const seed) {
                    return measure_lammps(plan, stiffness, deck, seed);
                });
    } catch (reference::LammpsError const& error) {
        std::cout << "without LAMMPS: " << error.what() << '\n';
    }
    return lines;
}

/// Slope of the logarithm of the error by that of the processor time, replicate by replicate.
Estimate slope(Line const& line, double const theory) {
    return mean_of(line.replicates, [&](Measurement const& replicate) {
        std::vector<double> x, y;
        for (std::size_t k = 0; k < line.durations(); ++k) {
            x.push_back(std::log(replicate[2 * k]));
            y.push_back(std::log(std::abs(replicate[2 * k + 1] - theory)));
        }
        return line_through(x, y).slope;
    });
}

Csv errors_of(std::vector<Line> const& lines, double const theory) {
    Csv csv({"method", "knob", "cpu_seconds", "relative_error"});
    for (Line const& line : lines)
        for (std::size_t k = 0; k < line.durations(); ++k) {
            Estimate const square = mean_of(line.replicates, [&](Measurement const& replicate) {
                return std::pow(replicate[2 * k + 1] / theory - 1, 2);
            });
            csv.row({line.method, line.knob, cell(mean_of(line.replicates, 2 * k).value),
                     cell(std::sqrt(square.value))});
        }
    return csv;
}

} // namespace

Verdict ask(Experiment& experiment) {
    Plan const plan = cost_of_statistics::plan(experiment.profile());
    std::vector<Line> const lines = measured(experiment, plan);
    double const theory = plan.point.theory();
    Ledger ledger({{"method", "method"}, {"knob", "knob"}});
    Comparison const rate{{}, slope(lines.front(), theory), -0.5, 0, slope_margin};
    ledger.compare({"fast", "double"}, {"slope", "slope"}, rate);
    for (Line const& line : lines) {
        Comparison const z{{}, line.last_z(), theory, 2e-5 * theory, bias_margin * theory};
        if (line.method == "fast")
            ledger.compare({line.method, line.knob}, {"Z", "$Z$"}, z);
        else
            ledger.guide({line.method, line.knob}, {"Z", "$Z$"}, z);
    }
    Macros macros("CostOfStatistics");
    macros.define("Balls", cell(plan.point.count));
    macros.define("PackingFraction", fmt::format("{}", plan.point.packing_fraction));
    macros.define("Slope", with_error(rate.measured));
    experiment.write(errors_of(lines, theory), "_errors");
    return conclude(experiment, ledger, macros);
}

} // namespace clack::validation
