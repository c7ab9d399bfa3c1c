// Does the crystal obey its equation of state, remain one, and press as its free volume vanishes?

#include "validation/crystal.hpp"

#include <algorithm>

namespace clack::validation {

using namespace crystal;

Question const question{
    "crystal",
    "Does the pressure of the face-centred cubic crystal, by virial and by collision rate, obey "
    "the equations of state of Schultz and of Speedy up to the divergence at close packing, and "
    "does it remain that crystal?",
    percent(margin) + " of Z; " + percent(divergence_margin) + " of the slope of the divergence; " +
        fmt::format("{:.3f} of the bond order", order_margin),
    "four tenths of what a diameter wrong by 0.1 % does and room for the terms of order 1/N that "
    "are left out; twice 1/N; half of what parts the lattice from the nearest other",
    Processes::one_a_state_point};

namespace {

Csv csv_of(std::vector<PeriodicRun> const& points,
           std::vector<std::vector<Measurement>> const& all) {
    Csv csv({"packing_fraction", "free_part", "count", "Z", "Z_error", "Z_schultz", "Z_speedy",
             "bond_order", "bond_order_error"});
    for (std::size_t k = 0; k < points.size(); ++k) {
        double const eta = points[k].packing_fraction;
        double const infinite = points[k].expected_of_infinitely_many();
        Estimate const z = mean_of(all[k], by_virial), bonds = mean_of(all[k], order);
        csv.row(eta, free_part(eta), points[k].count, z.value + infinite - points[k].expected(),
                z.error, infinite, reference::speedy_crystal(eta), bonds);
    }
    return csv;
}

Csv curves() {
    Csv csv({"packing_fraction", "Z_schultz", "Z_speedy", "Z_free_volume"});
    for (int k = 0; k <= 108; ++k) {
        double const eta = 0.52 + 0.002 * k;
        csv.row(eta, reference::schultz_crystal(eta), reference::speedy_crystal(eta),
                3 / free_part(eta));
    }
    return csv;
}

} // namespace

Verdict ask(Experiment& experiment) {
    auto const points = runs(experiment.profile());
    auto const all = experiment.campaign().replicates(tasks_of(points, measure));
    Ledger ledger({Key{"packing_fraction", "$\\eta$"}});
    double least_order = 1;
    for (std::size_t k = 0; k < points.size(); ++k) {
        enter(ledger, points[k], all[k]);
        least_order = std::min(least_order, mean_of(all[k], order).value);
    }
    Comparison const slope = divergence(points, all);
    double const densest = points.back().packing_fraction;
    ledger.compare({cell(densest)}, {"divergence", "slope of $Z$ against $1/y$"}, slope);
    experiment.write(csv_of(points, all), "_points");
    experiment.write(curves(), "_theory");
    Macros macros("Crystal");
    macros.define("LeastBondOrder", significant(least_order, 2));
    macros.define("LatticeBondOrder", significant(fcc_order, 3));
    macros.define("NearestBondOrder", significant(bcc_order, 3));
    macros.define("BondOrderMargin", significant(order_margin, 2));
    macros.define("Divergence", with_error(slope.measured));
    macros.define("DivergencePacking", fmt::format("{:.3f}", densest));
    macros.define("MarginPercent", significant(100 * margin, 1));
    return conclude(experiment, ledger, std::move(macros));
}

} // namespace clack::validation
