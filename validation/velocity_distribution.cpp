// Do balls that all start with one speed come to the exact law of finitely many balls?

#include "validation/velocity_distribution.hpp"

#include "validation/harness/experiment.hpp"
#include "validation/velocity_relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace clack::validation {

using namespace velocity_distribution;

Question const question{
    "velocity_distribution",
    "Do balls that start with equal speeds in a cube with walls relax to the exact velocity law of "
    "finitely many balls at constant energy?",
    "half the distance of the fourth moment from Maxwell and Boltzmann's",
    "their law would not pass for the exact one", Processes::one_a_state_point};

namespace {

/// A state point and what was measured there.
struct Row {
    StatePoint point;
    std::vector<Measurement> replicates;
    std::vector<std::int64_t> counts;

    double samples() const { return 1.0 * point.looks * point.replicates; }
    /// Whether the same counts refuse Maxwell and Boltzmann's law.
    double maxwell_p_value() const {
        return chi_square(counts, bin_probabilities(reference::MaxwellBoltzmann(1, 1))).p_value;
    }
};

/// How independent the samples are, and what the law of infinitely many balls would be worth.
Csv samples_of(std::vector<Row> const& rows) {
    Csv csv({"count", "packing_fraction", "samples", "collisions_per_ball_between_samples",
             "statistical_inefficiency", "p_chi_square_maxwell_boltzmann"});
    for (Row const& row : rows) {
        auto const mean = [&](double Sample::*const member) {
            return mean_of(row.replicates, [=](Measurement const& m) { return Sample(m).*member; });
        };
        csv.row({cell(row.point.count), cell(row.point.packing_fraction), cell(row.samples()),
                 cell(mean(&Sample::spacing).value), cell(mean(&Sample::inefficiency).value),
                 cell(row.maxwell_p_value())});
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
                     cell(static_cast<double>(row.counts[k]) * scale),
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

Relaxation relaxation_of(Profile const profile) {
    return profile == Profile::quick ? Relaxation{} : Relaxation{.replicates = 5000};
}

Course course_of(Relaxation const& relaxation, std::vector<Measurement> const& replicates) {
    Course course{relaxation, {}, {}};
    for (std::size_t look = 0; look < relaxation_looks().size(); ++look) {
        course.collisions.push_back(mean_of(replicates, 2 * look).value);
        course.moments.push_back(mean_of(replicates, 2 * look + 1));
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

/// A probability, or that there is hardly any.
std::string probability(double const p) { return p < 1e-100 ? "$< 10^{-100}$" : significant(p, 2); }

Macros macros_of(std::vector<Row> const& rows, Course const& course, Ledger const& ledger) {
    double least_p = 1;
    for (Entry const& entry : ledger.entries()) least_p = std::min(least_p, entry.p_value);
    Macros macros("VelocityDistribution");
    macros.define("FewestBalls", cell(rows.front().point.count));
    macros.define("MostBalls", cell(rows.back().point.count));
    macros.define("FewestSpeeds", significant(rows.front().samples(), 2));
    macros.define("LeastP", probability(least_p));
    macros.define("MaxwellBoltzmannP", probability(rows.front().maxwell_p_value()));
    macros.define("FirstRise", with_error(course.first_rise()));
    macros.define("FirstRiseTheory", significant(first_rise, 4));
    macros.define("RelaxationBalls", cell(course.relaxation.count));
    macros.define("RelaxationStarts", cell(course.relaxation.replicates));
    return macros;
}

} // namespace

Verdict ask(Experiment& experiment) {
    auto const points = state_points(experiment.profile());
    Relaxation const relaxation = relaxation_of(experiment.profile());
    auto tasks = tasks_of<StatePoint>(points, measure);
    tasks.push_back(tasks_of<Relaxation>({relaxation}, measure).front());
    auto const all = experiment.campaign().replicates(tasks);
    Ledger ledger({Key{"count", "$n$"}});
    std::vector<Row> rows;
    for (std::size_t k = 0; k < points.size(); ++k) {
        enter(ledger, points[k], all[k]);
        rows.push_back({points[k], all[k], counts_of(all[k])});
    }
    Course const course = course_of(relaxation, all.back());
    experiment.write(samples_of(rows), "_samples");
    experiment.write(histograms(rows), "_histogram");
    experiment.write(laws(rows.front().point), "_theory");
    experiment.write(csv_of(course), "_relaxation");
    return conclude(experiment, ledger, macros_of(rows, course, ledger));
}

} // namespace clack::validation
