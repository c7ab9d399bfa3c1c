// Does the pressure of the fluid obey its equation of state, finite-size term included?

#include "validation/equation_of_state.hpp"

#include <algorithm>
#include <cmath>

namespace clack::validation {

namespace {

using namespace equation_of_state;

Question const question{
    "equation_of_state",
    "Does the pressure of a periodic fluid of hard balls, by virial, by collision rate and by the"
    " contact value of g(r), obey the equations of state of Kolafa, Labik and Malijevsky "
    "(modified) and of Schultz with the 1/N term, and do the three ways to it agree?",
    "0.2 % of the collisional part Zc (full profile 0.1 %): two thirds (one third) of what a "
    "diameter wrong by 0.1 % does where it does least; for the contact value, which is "
    "extrapolated, five times as much"};

constexpr std::size_t kinds = 6; // of comparisons at a point

double collisions(StatePoint const& point) {
    return point.replicates * point.run.production * static_cast<double>(point.run.count) / 2;
}

/// Measured compressibility factor of infinitely many balls: the theory's difference between these
/// and N is taken off.
Estimate infinite(Finding const& virial) {
    Estimate estimate = virial.comparison.measured;
    estimate.value += reference::modified_klm(virial.at) - virial.comparison.reference;
    return estimate;
}

std::string table_of(std::vector<StatePoint> const& points, std::vector<Finding> const& all) {
    std::vector<std::vector<std::string>> cells;
    for (std::size_t k = 0; k < points.size(); ++k) {
        Finding const* const at = &all[kinds * k];
        std::vector<Judgement> judgements;
        for (std::size_t kind = 0; kind < kinds; ++kind) judgements.push_back(at[kind].judgement);
        std::vector<std::string> row{fmt::format("{:.2f}", at->at), cell(points[k].run.count),
                                     with_error(infinite(*at)),
                                     fmt::format("{:.5f}", reference::modified_klm(at->at))};
        for (std::size_t kind = 0; kind < 3; ++kind)
            row.push_back(fmt::format("${:+.1f}$", judgements[kind].z));
        row.emplace_back(name_of(together(judgements)));
        cells.push_back(row);
    }
    return tabular("rrlrrrrl",
                   {"$\\eta$", "$n$", "$Z$", "theory", "virial", "rate", "contact", "verdict"},
                   cells);
}

/// Points and theories for infinitely many balls, for the figure's upper panel.
Csv curves() {
    Csv csv({"packing_fraction", "Z_theory", "Z_carnahan_starling", "Z_schultz"});
    for (int percent = 0; percent <= 50; ++percent) {
        double const eta = percent / 100.0;
        csv.row({cell(eta), cell(reference::modified_klm(eta)),
                 cell(reference::carnahan_starling(eta)), cell(reference::schultz_fluid(eta))});
    }
    return csv;
}

Csv infinite_fluid(std::vector<Finding> const& all) {
    Csv csv({"packing_fraction", "Z", "Z_error", "Z_theory", "Z_carnahan_starling"});
    for (Finding const& finding : all)
        if (finding.quantity == "virial")
            csv.row({cell(finding.at), cell(infinite(finding).value), cell(infinite(finding).error),
                     cell(reference::modified_klm(finding.at)),
                     cell(reference::carnahan_starling(finding.at))});
    return csv;
}

void define_macros(Macros& macros, std::vector<StatePoint> const& points,
                   std::vector<Finding> const& all, double const blocking_ratio,
                   Profile const profile) {
    double count = 0, largest_deviation = 0;
    for (StatePoint const& point : points) count += collisions(point);
    for (Finding const& finding : all)
        if (finding.quantity == "virial" || finding.quantity == "rate")
            largest_deviation = std::max(
                largest_deviation,
                std::abs(finding.comparison.measured.value / finding.comparison.reference - 1));
    macros.define("BlockingRatio", significant(blocking_ratio, 2));
    macros.define("PackingFractions", cell(points.size()));
    macros.define("Collisions", significant(count, 2));
    macros.define("LowestPacking", fmt::format("{:.2f}", all.front().at));
    macros.define("HighestPacking", fmt::format("{:.2f}", all.back().at));
    macros.define("LargestDeviationPercent", significant(100 * largest_deviation, 2));
    macros.define("MarginPercent", significant(100 * margin(profile), 1));
    macros.define("ContactMarginPercent", significant(100 * contact_margin(profile), 1));
}

Verdict ask(Experiment& experiment) {
    Profile const profile = experiment.profile();
    auto const points = state_points(profile);
    Findings findings("packing_fraction", "$\\eta$");
    auto const replicates = experiment.campaign().replicates(tasks_of(
        points, [](StatePoint const& point, std::uint64_t seed) { return measure(point, seed); }));
    double squared_ratio = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        add_findings(findings, points[k], replicates[k], profile);
        squared_ratio +=
            std::pow(error_by_blocking(replicates[k]) / mean_of(replicates[k], by_virial).error, 2);
    }
    double const blocking_ratio = std::sqrt(squared_ratio / static_cast<double>(points.size()));
    Verdict const verdict = findings.conclude(experiment, "EquationOfState", [&](Macros& macros) {
        define_macros(macros, points, findings.all(), blocking_ratio, profile);
    });
    experiment.write(curves(), "_theory");
    experiment.write(infinite_fluid(findings.all()), "_infinite");
    experiment.write_table(table_of(points, findings.all()));
    return verdict;
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask,
                                  clack::validation::Processes::one_a_state_point);
}
