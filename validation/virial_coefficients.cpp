// Are the second, third and fourth virial coefficients of a dilute fluid the exact ones?

#include "validation/virial_coefficients.hpp"

namespace clack::validation {

using namespace virial_coefficients;

Question const question{
    "virial_coefficients",
    "Are the second, third and fourth virial coefficients, fitted together to the pressure of "
    "dilute fluids, those that are known exactly?",
    fmt::format("{} of B2; {} of B3; {} of B4 (full profile {:g} times as much)",
                percent(margins[0]), percent(margins[1]), percent(margins[2]),
                part_of_margin(Profile::full)),
    "half of what a diameter wrong by 0.1 % does to B2; some five standard errors",
    Processes::one_a_state_point};

namespace {

/// (Z - 1 - B2 eta) / eta^2, which begins as B3 + B4 eta, beside the series with more and more of
/// its orders.
Csv points_of(std::vector<PeriodicRun> const& runs,
              std::vector<std::vector<Measurement>> const& all) {
    Csv csv({"packing_fraction", "count", "beyond_B2", "beyond_B2_error", "theory"});
    for (std::size_t k = 0; k < runs.size(); ++k) {
        double const eta = runs[k].packing_fraction, square = eta * eta;
        double const theory = runs[k].expected_of_infinitely_many();
        Estimate const z = mean_of(all[k], 0);
        double const infinite = z.value + theory - runs[k].expected();
        csv.row({cell(eta), cell(runs[k].count), cell((infinite - 1 - 4 * eta) / square),
                 cell(z.error / square), cell((theory - 1 - 4 * eta) / square)});
    }
    return csv;
}

Csv curves() {
    auto const table = reference::PublishedTable::of_reference("virial_coefficients.csv");
    Csv csv({"packing_fraction", "theory", "up_to_B4", "up_to_B6"});
    for (int k = 0; k <= 48; ++k) {
        double const eta = k / 200.0;
        double sum = 0, to_b4 = 0, to_b6 = 0;
        for (std::size_t row = 1; row < table.row_count(); ++row) {
            double const order = table.column("order")[row];
            sum += table.column("coefficient")[row] * std::pow(eta, order - 3);
            if (order <= 4) to_b4 = sum;
            if (order <= 6) to_b6 = sum;
        }
        csv.row({cell(eta), cell(sum), cell(to_b4), cell(to_b6)});
    }
    return csv;
}

} // namespace

Verdict ask(Experiment& experiment) {
    auto const points = runs(experiment.profile());
    auto const all = experiment.campaign().replicates(tasks_of(points, measure));
    double collisions = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
        collisions += points[k].collisions(all[k].size());
    Ledger ledger({Key{"order", "order"}});
    enter(ledger, points, all, experiment.profile());
    experiment.write(points_of(points, all), "_points");
    experiment.write(curves(), "_theory");
    Macros macros("VirialCoefficients");
    char const* const names[] = {"Second", "Third", "Fourth"};
    for (std::size_t k = 0; k < fitted; ++k)
        macros.define(names[k], with_error(ledger.entries()[k].comparison.measured));
    macros.define("Collisions", significant(collisions, 2));
    macros.define("HighestPacking", fmt::format("{:.2f}", points.back().packing_fraction));
    return conclude(experiment, ledger, std::move(macros));
}

} // namespace clack::validation
