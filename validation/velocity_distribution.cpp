// Do balls that all start with one speed come to the exact law of finitely many balls?

#include "validation/velocity_distribution.hpp"

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

reference::MaxwellBoltzmann const maxwell_boltzmann(1, 1);

/// A state point and how many speeds lie in each bin.
struct Row {
    StatePoint point;
    std::vector<std::int64_t> counts;

    double samples() const { return 1.0 * point.looks * point.replicates; }
    /// Whether the same counts refuse Maxwell and Boltzmann's law.
    double maxwell_p_value() const {
        return chi_square(counts, bin_probabilities(maxwell_boltzmann)).p_value;
    }
};

/// Mean densities in the bins, all in units of sqrt(kT/m).
Csv histograms(std::vector<Row> const& rows) {
    Csv csv({"count", "speed_per_thermal_speed", "density", "density_error", "density_theory",
             "density_maxwell_boltzmann"});
    auto const limit = bin_probabilities(maxwell_boltzmann);
    for (Row const& row : rows) {
        auto const exact = bin_probabilities(law_of(row.point));
        double const scale = 1 / (row.samples() * bin_width);
        for (std::size_t k = 0; k + 1 < bin_count; ++k) // the last bin has no width
            csv.row(row.point.count, (static_cast<double>(k) + 0.5) * bin_width,
                    static_cast<double>(row.counts[k]) * scale,
                    std::sqrt(row.samples() * exact[k] * (1 - exact[k])) * scale,
                    exact[k] / bin_width, limit[k] / bin_width);
    }
    return csv;
}

/// Both laws as lines.
Csv laws(StatePoint const& point) {
    Csv csv({"speed_per_thermal_speed", "density_theory", "density_maxwell_boltzmann"});
    reference::VelocityLaw const law = law_of(point);
    for (int k = 0; k <= 180; ++k) {
        double const speed = 4.5 * k / 180;
        csv.row(speed, law.speed_density(speed), maxwell_boltzmann.speed_density(speed));
    }
    return csv;
}

Macros macros_of(std::vector<Row> const& rows, Relaxation const& relaxation,
                 std::vector<Measurement> const& course, Ledger const& ledger) {
    double least_p = 1;
    for (Entry const& entry : ledger.entries()) least_p = std::min(least_p, entry.p_value);
    auto const probability = [](double const p) { // or that there is hardly any
        return p < 1e-100 ? "$< 10^{-100}$" : significant(p, 2);
    };
    double const collisions = mean_of(course, 0).value; // up to the first look
    Estimate const moment = mean_of(course, 1);
    Macros macros("VelocityDistribution");
    macros.define("FewestBalls", cell(rows.front().point.count));
    macros.define("LeastP", probability(least_p));
    macros.define("MaxwellBoltzmannP", probability(rows.front().maxwell_p_value()));
    macros.define("FirstRise",
                  with_error({(moment.value - 1) / collisions, moment.error / collisions}));
    macros.define("FirstRiseTheory", significant(first_rise, 4));
    macros.define("RelaxationBalls", cell(relaxation.count));
    macros.define("RelaxationStarts", cell(relaxation.replicates));
    return macros;
}

} // namespace

Verdict ask(Experiment& experiment) {
    auto const points = state_points(experiment.profile());
    Relaxation relaxation;
    if (experiment.profile() == Profile::full) relaxation.replicates = 5000;
    auto tasks = tasks_of<StatePoint>(points, measure);
    tasks.push_back(tasks_of<Relaxation>({relaxation}, measure).front());
    auto const all = experiment.campaign().replicates(tasks);
    Ledger ledger({Key{"count", "$n$"}});
    std::vector<Row> rows;
    for (std::size_t k = 0; k < points.size(); ++k) {
        enter(ledger, points[k], all[k]);
        rows.push_back({points[k], counts_of(all[k])});
    }
    experiment.write(histograms(rows), "_histogram");
    experiment.write(laws(rows.front().point), "_theory");
    experiment.write(course_of(relaxation, all.back()), "_relaxation");
    return conclude(experiment, ledger, macros_of(rows, relaxation, all.back(), ledger));
}

} // namespace clack::validation
