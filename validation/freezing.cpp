// Do fluid and crystal coexist at the pressure at which they should, by their measured pressures?

#include "validation/freezing.hpp"

namespace clack::validation {

using namespace freezing;

Question const question{
    "freezing",
    "Do the measured pressures of fluid and crystal follow their equations of state about "
    "coexistence, do their chemical potentials meet at its known pressure, and does a fluid "
    "beyond it not pass for the crystal?",
    percent(margin) + " of Z; " + percent(meeting_margin) + " of the pressure of coexistence",
    "about half of what a diameter wrong by 0.1 % does; some twice what that much of Z in the "
    "fluid "
    "shifts the pressure by",
    Processes::one_a_state_point};

namespace {

using All = std::vector<std::vector<Measurement>>;

/// Pressures of infinitely many balls: what theory expects less of N is added.
void add_points(Csv& csv, std::vector<PeriodicRun> const& runs, All const& all) {
    for (std::size_t k = 0; k < runs.size(); ++k) {
        double const rho = runs[k].number_density();
        double const infinite = runs[k].expected_of_infinitely_many();
        Estimate const z = mean_of(all[k], by_virial);
        csv.row({runs[k].is_crystal() ? "crystal" : "fluid", cell(rho),
                 cell(rho * (z.value + infinite - runs[k].expected())), cell(rho * z.error),
                 cell(rho * infinite), cell(mean_of(all[k], order).value)});
    }
}

Csv curves() {
    Csv csv({"number_density_per_diameter3", "P_fluid", "P_crystal", "P_coexistence"});
    for (int k = 0; k <= 52; ++k) {
        double const rho = 0.84 + 0.005 * k, eta = rho * std::numbers::pi / 6;
        csv.row({cell(rho), eta < 0.54 ? cell(rho * reference::modified_klm(eta)) : "nan",
                 eta > 0.52 ? cell(rho * reference::schultz_crystal(eta)) : "nan",
                 cell(reference::coexistence_pressure)});
    }
    return csv;
}

} // namespace

Verdict ask(Experiment& experiment) {
    Branches const both = branches(experiment.profile());
    std::vector<PeriodicRun> runs = both.fluid;
    runs.insert(runs.end(), both.crystal.begin(), both.crystal.end());
    runs.push_back(forced_fluid());
    All const all = experiment.campaign().replicates(tasks_of(runs, measure));
    auto const boundary = all.begin() + static_cast<std::ptrdiff_t>(both.fluid.size());
    All const fluid(all.begin(), boundary), solid(boundary, all.end() - 1);

    Ledger ledger({Key{"number_density_per_diameter3", "$\\rho$"}});
    for (std::size_t k = 0; k + 1 < runs.size(); ++k) enter(ledger, runs[k], all[k]);
    Comparison const met = meeting(both, fluid, solid), forced = pretence(all.back());
    double const rho = forced_fluid().number_density();
    ledger.compare({"both"}, {"coexistence", "$p$ of coexistence"}, met);
    ledger.compare({fmt::format("{:.4g}", rho)}, {"forced_fluid", "$Z$, forced fluid"}, forced);

    Csv points(
        {"branch", "number_density_per_diameter3", "P", "P_error", "P_theory", "bond_order"});
    add_points(points, both.fluid, fluid);
    add_points(points, both.crystal, solid);
    Estimate const bonds = mean_of(all.back(), order);
    points.row({"forced", cell(rho), cell(rho * forced.measured.value),
                cell(rho * forced.measured.error), cell(rho * forced.reference),
                cell(bonds.value)});
    experiment.write(points, "_points");
    experiment.write(curves(), "_theory");
    Macros macros("Freezing");
    macros.define("Pressure", with_error(met.measured));
    macros.define("PressureTheory", fmt::format("{:.4f}", reference::coexistence_pressure));
    macros.define("ForcedZ", with_error(forced.measured));
    macros.define("ForcedCrystalZ", fmt::format("{:.3f}", forced.reference));
    macros.define("ForcedBondOrder", with_error(bonds));
    return conclude(experiment, ledger, std::move(macros));
}

} // namespace clack::validation
