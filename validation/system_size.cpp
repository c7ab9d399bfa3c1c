// Does the pressure go to that of infinitely many balls as the inverse of their number?

#include "validation/system_size.hpp"

namespace clack::validation {

namespace {

using namespace system_size;

Question const question{
    "system_size",
    "Does the compressibility factor of N balls in a periodic cube differ from that of infinitely"
    " many by - 1/N - (rho / 2N) P'' / P'?",
    "0.15 % of the collisional part at each N, half of what a diameter wrong by 0.1 % does; a "
    "third of the slope against 1/N, which N in the place of N - 1 would change by more than "
    "itself"};

Csv csv_of(std::vector<StatePoint> const& points,
           std::vector<std::vector<Measurement>> const& all) {
    Csv csv({"count", "Z", "Z_error", "Z_theory", "Z_infinite", "judged"});
    for (std::size_t k = 0; k < points.size(); ++k) {
        PeriodicRun const& run = points[k].run;
        Estimate const z = mean_of(all[k], 0);
        csv.row({cell(run.count), cell(z.value), cell(z.error),
                 cell(reference::periodic_compressibility(run.number_density(), run.count)),
                 cell(reference::modified_klm(run.packing_fraction)),
                 cell(run.count >= fewest_judged ? 1 : 0)});
    }
    return csv;
}

Verdict ask(Experiment& experiment) {
    auto const points = state_points(experiment.profile());
    std::vector<std::vector<Measurement>> all;
    for (StatePoint const& point : points)
        all.push_back(experiment.campaign().replicates(
            point.run.text(), point.replicates,
            [&](std::uint64_t const seed) { return measure(point, seed); }));
    Findings findings("count", "$n$");
    add_findings(findings, points, all);
    experiment.write(csv_of(points, all), "_points");
    return findings.conclude(experiment, "SystemSize", [&](Macros& macros) {
        auto const& slope = findings.all()[findings.all().size() - 2].comparison;
        macros.define("Slope", with_error(slope.measured));
        macros.define("SlopeTheory", fmt::format("{:.3f}", slope.reference));
        macros.define("FewestJudged", cell(fewest_judged));
        macros.define("MostBalls", cell(points.back().run.count));
    });
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask);
}
