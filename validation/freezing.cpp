// Do fluid and crystal coexist at the pressure at which they should, by their measured pressures?

#include "validation/freezing.hpp"

#include <iostream>

namespace clack::validation {

namespace {

using namespace freezing;

Question const question{
    "freezing",
    "Do the measured pressures of fluid and crystal follow their equations of state about "
    "coexistence, do their chemical potentials meet at its known pressure, and does a fluid "
    "beyond it not pass for the crystal?",
    "0.4 % of Z, about half of what a diameter wrong by 0.1 % does; 1 % of the pressure of "
    "coexistence, some twice what that much of Z in the fluid shifts it by"};

using All = std::vector<std::vector<Measurement>>;

All measured(Experiment& experiment, std::vector<PeriodicRun> const& runs, Findings& findings) {
    All all;
    for (PeriodicRun const& run : runs) {
        all.push_back(experiment.campaign().replicates(
            run.text(), replicates, [&](std::uint64_t const seed) { return measure(run, seed); }));
        add_branch(findings, run, all.back());
    }
    return all;
}

/// Pressures of infinitely many balls: what theory expects less of N is added.
void add_points(Csv& csv, std::vector<PeriodicRun> const& runs, All const& all) {
    for (std::size_t k = 0; k < runs.size(); ++k) {
        bool const solid = runs[k].arrangement == Arrangement::fcc;
        double const eta = runs[k].packing_fraction, rho = runs[k].number_density();
        double const infinite =
            solid ? reference::schultz_crystal(eta) : reference::modified_klm(eta);
        Estimate const z = mean_of(all[k], by_virial);
        csv.row({solid ? "crystal" : "fluid", cell(rho),
                 cell(rho * (z.value + infinite - theory_of(runs[k]))), cell(rho * z.error),
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

Verdict ask(Experiment& experiment) {
    Findings findings("number_density_per_diameter3", "$\\rho$ or $p$");
    Branches const both = branches(experiment.profile());
    All const fluid = measured(experiment, both.fluid, findings);
    All const solid = measured(experiment, both.crystal, findings);
    findings.add(meeting(both, fluid, solid));
    auto const forced = experiment.campaign().replicates(
        forced_fluid().text(), replicates,
        [&](std::uint64_t const seed) { return measure(forced_fluid(), seed); });
    Comparison const beside = pretence(forced);
    Judgement const judged = judge({beside}).front();
    Estimate const bonds = mean_of(forced, order);

    Csv points(
        {"branch", "number_density_per_diameter3", "P", "P_error", "P_theory", "bond_order"});
    add_points(points, both.fluid, fluid);
    add_points(points, both.crystal, solid);
    double const rho = forced_fluid().number_density();
    points.row({"forced", cell(rho), cell(rho * beside.measured.value),
                cell(rho * beside.measured.error), cell(rho * beside.reference),
                cell(bonds.value)});
    experiment.write(points, "_points");
    experiment.write(curves(), "_theory");

    bool const shows_itself = judged.verdict == Verdict::differs;
    std::cout << fmt::format("fluid at packing fraction {}: Z = {}, the crystal's {:.3f}, bond "
                             "order {}: {}\n",
                             forced_fluid().packing_fraction, with_error(beside.measured),
                             beside.reference, with_error(bonds),
                             shows_itself ? "is not the crystal" : "passes for the crystal");
    Estimate const pressure = findings.all().back().comparison.measured;
    findings.require(shows_itself ? Verdict::agrees : Verdict::differs);
    return findings.conclude(experiment, "Freezing", [&](Macros& macros) {
        macros.define("Pressure", with_error(pressure));
        macros.define("PressureTheory", fmt::format("{:.4f}", reference::coexistence_pressure));
        macros.define("ForcedZ", with_error(beside.measured));
        macros.define("ForcedCrystalZ", fmt::format("{:.3f}", beside.reference));
        macros.define("ForcedBondOrder", with_error(bonds));
    });
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask);
}
