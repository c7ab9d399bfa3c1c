// Does the pressure go to that of infinitely many balls as the inverse of their number?

#include "validation/system_size.hpp"

namespace clack::validation {

using namespace system_size;

Question const question{
    "system_size",
    "Does the compressibility factor of N balls in a periodic cube differ from that of infinitely"
    " many by - 1/N - (rho / 2N) P'' / P'?",
    percent(margin) + " of the collisional part at each N; " + percent(slope_margin) +
        " of the slope against 1/N",
    "half of what a diameter wrong by 0.1 % does; N in the place of N - 1 would change the slope "
    "by "
    "more than itself",
    Processes::one_a_state_point};

namespace {

Csv csv_of(std::vector<PeriodicRun> const& points,
           std::vector<std::vector<Measurement>> const& all) {
    Csv csv({"count", "Z", "Z_error", "Z_theory", "Z_infinite", "judged"});
    for (std::size_t k = 0; k < points.size(); ++k) {
        Estimate const z = mean_of(all[k], 0);
        csv.row({cell(points[k].count), cell(z.value), cell(z.error), cell(points[k].expected()),
                 cell(points[k].expected_of_infinitely_many()),
                 cell(points[k].count >= fewest_judged ? 1 : 0)});
    }
    return csv;
}

} // namespace

Verdict ask(Experiment& experiment) {
    auto const points = state_points(experiment.profile());
    auto const all = experiment.campaign().replicates(tasks_of(points, measure));
    Ledger ledger({Key{"count", "$n$"}});
    enter(ledger, points, all);
    experiment.write(csv_of(points, all), "_points");
    Macros macros("SystemSize");
    auto const& slope = ledger.entries()[ledger.entries().size() - 2].comparison;
    macros.define("Slope", with_error(slope.measured));
    macros.define("SlopeTheory", fmt::format("{:.3f}", slope.reference));
    macros.define("FewestJudged", cell(fewest_judged));
    macros.define("MostBalls", cell(points.back().count));
    return conclude(experiment, ledger, std::move(macros));
}

} // namespace clack::validation
