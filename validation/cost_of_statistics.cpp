// What does one more digit of a statistical result cost with each method, and where does its bias
// end it?

#include "validation/cost_of_statistics.hpp"

#include "validation/harness/experiment.hpp"
#include "validation/harness/straight_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <functional>
#include <iostream>

namespace clack::validation {

using namespace cost_of_statistics;

Question const question{
    "cost_of_statistics",
    "Does the engine's error of the compressibility factor fall as the root of the processor time"
    " without end, where steps of time and soft balls stop at a bias?",
    "slope of the error's logarithm by that of the time -1/2 +- 0.15; bias of the engine 0 +- 0.3 "
    "% "
    "of Z",
    "far from the slope 0 of a bias and from the -1 of a method that integrates; a tenth of the "
    "bias "
    "of the softest balls; the biases of the others are shown"};

namespace {

constexpr double slope_margin = 0.15, bias_margin = 3e-3;

/// A method with its knob: processor time and Z of all replicates, for each duration.
struct Line {
    std::string method, knob;
    std::vector<Measurement> replicates;

    std::size_t durations() const { return replicates.front().size() / 2; }
    Estimate column(std::size_t const place) const {
        std::vector<double> values;
        for (Measurement const& replicate : replicates) values.push_back(replicate[place]);
        return mean_of(values);
    }
};

std::vector<Line> measured(Experiment& experiment, Plan const& plan) {
    std::vector<Line> lines;
    auto const add = [&](std::string const& method, std::string const& knob, int const replicates,
                         Measure const& measure) {
        std::string const text =
            fmt::format("{} {} packing_fraction={} count={} durations={} stepped={}", method, knob,
                        plan.point.packing_fraction, plan.point.count,
                        fmt::join(plan.durations, ","), plan.stepped_durations);
        lines.push_back(
            {method, knob, experiment.campaign().replicates(text, replicates, measure)});
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
Comparison slope(Line const& line, Plan const& plan) {
    std::vector<double> slopes;
    for (Measurement const& replicate : line.replicates) {
        std::vector<double> x, y;
        for (std::size_t k = 0; k < line.durations(); ++k) {
            x.push_back(std::log(replicate[2 * k]));
            y.push_back(std::log(std::abs(replicate[2 * k + 1] - plan.point.theory())));
        }
        slopes.push_back(line_through(x, y).slope);
    }
    return {"slope of fast", mean_of(slopes), -0.5, 0, slope_margin};
}

Comparison bias(Line const& line, Plan const& plan) {
    Estimate const z = line.column(2 * line.durations() - 1);
    return {"Z of fast", z, plan.point.theory(), 2e-5 * plan.point.theory(),
            bias_margin * plan.point.theory()};
}

Csv csv_of(std::vector<Line> const& lines, Plan const& plan) {
    Csv csv({"method", "knob", "collisions_per_ball", "cpu_seconds", "relative_error",
             "relative_bias", "relative_bias_error"});
    double const theory = plan.point.theory();
    for (Line const& line : lines)
        for (std::size_t k = 0; k < line.durations(); ++k) {
            double squares = 0;
            for (Measurement const& replicate : line.replicates)
                squares += std::pow(replicate[2 * k + 1] / theory - 1, 2);
            Estimate const z = line.column(2 * k + 1);
            csv.row({line.method, line.knob, cell(plan.durations[k]),
                     cell(line.column(2 * k).value),
                     cell(std::sqrt(squares / static_cast<double>(line.replicates.size()))),
                     cell(z.value / theory - 1), cell(z.error / theory)});
        }
    return csv;
}

} // namespace

Verdict ask(Experiment& experiment) {
    Plan const plan = cost_of_statistics::plan(experiment.profile());
    std::vector<Line> const lines = measured(experiment, plan);
    std::vector<Comparison> const comparisons{slope(lines.front(), plan),
                                              bias(lines.front(), plan)};
    auto const judgements = judge(comparisons);
    for (std::size_t k = 0; k < comparisons.size(); ++k) {
        Comparison const& c = comparisons[k];
        std::cout << fmt::format(
            "{}: {:.4f} +- {:.4f}, expected {:.4f} +- {:.4f}: z = {:+.1f}  {}\n", c.name,
            c.measured.value, c.measured.error, c.reference, c.margin, judgements[k].z,
            name_of(judgements[k].verdict));
    }
    Macros macros("CostOfStatistics");
    macros.define("Profile", name_of(experiment.profile()));
    macros.define("Balls", cell(plan.point.count));
    macros.define("PackingFraction", fmt::format("{}", plan.point.packing_fraction));
    macros.define("Slope", with_error(comparisons[0].measured));
    macros.define("Verdict", name_of(together(judgements)));
    for (Line const& line : lines) {
        Estimate const z = line.column(2 * line.durations() - 1);
        double const percent = 100 * (z.value / plan.point.theory() - 1);
        std::cout << fmt::format("{} {}: bias {:+.2f} +- {:.2f} %\n", line.method, line.knob,
                                 percent, 100 * z.error / plan.point.theory());
    }
    experiment.write(csv_of(lines, plan));
    experiment.write(macros);
    return together(judgements);
}

} // namespace clack::validation
