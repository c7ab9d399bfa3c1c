// Do balls that all start with one speed come to the exact law of finitely many balls?

#include "validation/velocity_distribution.hpp"

#include "validation/harness/experiment.hpp"
#include "validation/velocity_relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace clack::validation {

namespace {

using namespace velocity_distribution;

Question const question{
    "velocity_distribution",
    "Do balls that start with equal speeds in a cube with walls relax to the exact velocity law of "
    "finitely many balls at constant energy?",
    "half the distance of the fourth moment from Maxwell and Boltzmann's, so that their law would "
    "not pass for the exact one"};

/// A state point with all that was found out about it.
struct Row {
    StatePoint point;
    Findings findings;
    Judgement moment;
    Verdict verdict;
    double spacing, inefficiency; // means over the replicates

    double samples() const { return 1.0 * point.looks * point.replicates; }
};

std::vector<Row> measured(Experiment& experiment) {
    std::vector<Row> rows;
    std::vector<Findings> all;
    std::vector<Comparison> moments;
    auto const points = state_points(experiment.profile());
    auto const replicates = experiment.campaign().replicates(tasks_of(
        points, [](StatePoint const& point, std::uint64_t seed) { return measure(point, seed); }));
    for (std::size_t k = 0; k < points.size(); ++k) {
        StatePoint const& point = points[k];
        all.push_back(find(point, replicates[k]));
        moments.push_back(all.back().fourth_moment);
        rows.push_back({point, all.back(), {}, {}, 0, 0});
        for (Measurement const& measurement : replicates[k]) {
            rows.back().spacing += Sample(measurement).spacing / point.replicates;
            rows.back().inefficiency += Sample(measurement).inefficiency / point.replicates;
        }
    }
    auto const judgements = judge(moments);
    auto const verdicts = judge_points(all);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].moment = judgements[k];
        rows[k].verdict = verdicts[k];
    }
    return rows;
}

/// Whether the same counts refuse Maxwell and Boltzmann's law.
double maxwell_p_value(Row const& row) {
    auto const limit = bin_probabilities(reference::MaxwellBoltzmann(1, 1));
    return chi_square(row.findings.counts, limit).p_value;
}

Csv csv_of(std::vector<Row> const& rows) {
    Csv csv({"count", "packing_fraction", "samples", "collisions_per_ball_between_samples",
             "statistical_inefficiency", "fourth_moment", "fourth_moment_error",
             "fourth_moment_theory", "margin", "z", "p_chi_square", "p_kolmogorov_smirnov",
             "p_anderson_darling", "p_chi_square_maxwell_boltzmann", "verdict"});
    for (Row const& row : rows) {
        Comparison const& moment = row.findings.fourth_moment;
        csv.row({cell(row.point.count), cell(row.point.packing_fraction), cell(row.samples()),
                 cell(row.spacing), cell(row.inefficiency), cell(moment.measured.value),
                 cell(moment.measured.error), cell(moment.reference), cell(moment.margin),
                 cell(row.moment.z), cell(row.findings.fits[0].p_value),
                 cell(row.findings.fits[1].p_value), cell(row.findings.fits[2].p_value),
                 cell(maxwell_p_value(row)), cell(name_of(row.verdict))});
    }
    return csv;
}

/// Mean densities in the bins, all in units of sqrt(kT/m).
Csv histograms(std::vector<Row> const& rows) {
    Csv csv({"count", "speed_per_thermal_speed", "density", "density_error", "density_theory",
             "density_maxwell_boltzmann"});
    auto const limit = bin_probabilities(reference::MaxwellBoltzmann(1, 1));
    for (Row const& row : rows) {
        auto const exact = bin_probabilities(law_of(row.point));
        for (std::size_t k = 0; k + 1 < bin_count; ++k) { // the last bin has no width
            double const middle = (static_cast<double>(k) + 0.5) * bin_width;
            double const scale = 1 / (row.samples() * bin_width);
            csv.row({cell(row.point.count), cell(middle),
                     cell(static_cast<double>(row.findings.counts[k]) * scale),
                     cell(std::sqrt(row.samples() * exact[k] * (1 - exact[k])) * scale),
                     cell(exact[k] / bin_width), cell(limit[k] / bin_width)});
        }
    }
    return csv;
}

/// Both laws as lines.
Csv laws(StatePoint const& point) {
    Csv csv({"speed_per_thermal_speed", "density_theory", "density_maxwell_boltzmann"});
    reference::VelocityLaw const law = law_of(point);
    reference::MaxwellBoltzmann const limit(1, 1);
    for (int k = 0; k <= 180; ++k) {
        double const speed = 4.5 * k / 180;
        csv.row({cell(speed), cell(law.speed_density(speed)), cell(limit.speed_density(speed))});
    }
    return csv;
}

/// <v^4> / <v^2>^2 against collisions per ball, over many starts.
struct Course {
    Relaxation relaxation;
    std::vector<double> collisions;
    std::vector<Estimate> moments;

    /// Rise per collision of a ball up to the first look.
    Estimate first_rise() const {
        return {(moments.front().value - 1) / collisions.front(),
                moments.front().error / collisions.front(), moments.front().degrees_of_freedom};
    }
};

Course relax(Experiment& experiment) {
    Course course;
    if (experiment.profile() == Profile::full) course.relaxation.replicates = 5000;
    auto const replicates = experiment.campaign().replicates(
        course.relaxation.text(), course.relaxation.replicates,
        [&](std::uint64_t const seed) { return measure(course.relaxation, seed); });
    for (std::size_t look = 0; look < relaxation_looks().size(); ++look) {
        std::vector<double> collisions, moments;
        for (Measurement const& measurement : replicates) {
            collisions.push_back(measurement[2 * look]);
            moments.push_back(measurement[2 * look + 1]);
        }
        course.collisions.push_back(mean_of(collisions).value);
        course.moments.push_back(mean_of(moments));
    }
    return course;
}

Csv csv_of(Course const& course) {
    double const end =
        law_of({course.relaxation.count, course.relaxation.packing_fraction, 0, 0, 0, 0})
            .fourth_moment_ratio();
    Csv csv({"collisions_per_ball", "fourth_moment", "fourth_moment_error", "first_rise",
             "fourth_moment_theory"});
    csv.row({cell(0), cell(1), cell(0), cell(1), cell(end)});
    for (std::size_t look = 0; look < course.moments.size(); ++look) {
        csv.row({cell(course.collisions[look]), cell(course.moments[look].value),
                 cell(course.moments[look].error), cell(1 + first_rise * course.collisions[look]),
                 cell(end)});
    }
    return csv;
}

std::string table_of(std::vector<Row> const& rows) {
    std::vector<std::vector<std::string>> cells;
    for (Row const& row : rows) {
        std::vector<std::string> line{cell(row.point.count), significant(row.samples(), 2),
                                      with_error(row.findings.fourth_moment.measured),
                                      fmt::format("{:.5f}", row.findings.fourth_moment.reference),
                                      fmt::format("${:+.1f}$", row.moment.z)};
        for (GoodnessOfFit const& fit : row.findings.fits)
            line.push_back(fmt::format("{:.2f}", fit.p_value));
        line.push_back(name_of(row.verdict));
        cells.push_back(line);
    }
    return tabular("rrlrrrrrl",
                   {"$n$", "speeds", "$\\langle v^4\\rangle/\\langle v^2\\rangle^2$", "theory",
                    "$z$", "$\\chi^2$", "KS", "AD", "verdict"},
                   cells);
}

/// A probability, or that there is hardly any.
std::string probability(double const p) { return p < 1e-100 ? "$< 10^{-100}$" : significant(p, 2); }

Macros macros_of(std::vector<Row> const& rows, Course const& course, Profile const profile,
                 Verdict const verdict) {
    double largest_z = 0, least_p = 1;
    for (Row const& row : rows) {
        largest_z = std::max(largest_z, std::abs(row.moment.z));
        for (GoodnessOfFit const& fit : row.findings.fits) least_p = std::min(least_p, fit.p_value);
    }
    Macros macros("VelocityDistribution");
    macros.define("Profile", name_of(profile));
    macros.define("FewestBalls", cell(rows.front().point.count));
    macros.define("MostBalls", cell(rows.back().point.count));
    macros.define("FewestSpeeds", significant(rows.front().samples(), 2));
    macros.define("LargestZ", significant(largest_z, 2));
    macros.define("LeastP", probability(least_p));
    macros.define("MaxwellBoltzmannP", probability(maxwell_p_value(rows.front())));
    macros.define("FirstRise", with_error(course.first_rise()));
    macros.define("FirstRiseTheory", significant(first_rise, 4));
    macros.define("RelaxationBalls", cell(course.relaxation.count));
    macros.define("RelaxationStarts", cell(course.relaxation.replicates));
    macros.define("FalseAlarmPercent", significant(100 * Risks{}.false_alarm, 1));
    macros.define("Verdict", name_of(verdict));
    return macros;
}

Verdict ask(Experiment& experiment) {
    std::vector<Row> const rows = measured(experiment);
    Course const course = relax(experiment);
    std::vector<Verdict> verdicts;
    for (Row const& row : rows) {
        verdicts.push_back(row.verdict);
        auto const& fits = row.findings.fits;
        std::cout << fmt::format("{:3} balls: <v^4>/<v^2>^2 = {}  theory {:.5f}  z = {:+.1f}  "
                                 "p = {:.2f} (chi-square), {:.2f} (KS), {:.2f} (AD)  {}\n",
                                 row.point.count, with_error(row.findings.fourth_moment.measured),
                                 row.findings.fourth_moment.reference, row.moment.z,
                                 fits[0].p_value, fits[1].p_value, fits[2].p_value,
                                 name_of(row.verdict));
    }
    std::cout << fmt::format(
        "first rise of <v^4>/<v^2>^2 per collision of a ball: {}  theory {:.5f}\n",
        with_error(course.first_rise()), first_rise);
    Verdict const verdict = together(verdicts);
    experiment.write(histograms(rows), "_histogram");
    experiment.write(laws(rows.front().point), "_theory");
    experiment.write(csv_of(course), "_relaxation");
    experiment.write(macros_of(rows, course, experiment.profile(), verdict));
    experiment.write_table(table_of(rows));
    experiment.write(csv_of(rows));
    return verdict;
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask,
                                  clack::validation::Processes::one_a_state_point);
}
