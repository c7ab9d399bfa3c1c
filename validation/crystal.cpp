// Does the crystal obey its equation of state, remain one, and press as its free volume vanishes?

#include "validation/crystal.hpp"

#include <algorithm>

namespace clack::validation {

namespace {

using namespace crystal;

Question const question{
    "crystal",
    "Does the pressure of the face-centred cubic crystal, by virial and by collision rate, obey "
    "the equations of state of Schultz and of Speedy up to the divergence at close packing, and "
    "does it remain that crystal?",
    "0.4 % of Z, four tenths of what a diameter wrong by 0.1 % does and room for the terms of "
    "order 1/N that are left out; 0.4 % of the slope of the divergence, twice 1/N; half of the "
    "bond order, which tells the crystal from a fluid"};

Csv csv_of(std::vector<PeriodicRun> const& points,
           std::vector<std::vector<Measurement>> const& all) {
    Csv csv({"packing_fraction", "free_part", "count", "Z", "Z_error", "Z_schultz", "Z_speedy",
             "bond_order", "bond_order_error"});
    for (std::size_t k = 0; k < points.size(); ++k) {
        double const eta = points[k].packing_fraction;
        double const infinite = reference::schultz_crystal(eta);
        double const finite = reference::periodic_crystal(eta, points[k].count);
        Estimate const z = mean_of(all[k], by_virial), bonds = mean_of(all[k], order);
        csv.row({cell(eta), cell(free_part(eta)), cell(points[k].count),
                 cell(z.value + infinite - finite), cell(z.error), cell(infinite),
                 cell(reference::speedy_crystal(eta)), cell(bonds.value), cell(bonds.error)});
    }
    return csv;
}

Csv curves() {
    Csv csv({"packing_fraction", "Z_schultz", "Z_speedy", "Z_free_volume"});
    for (int k = 0; k <= 108; ++k) {
        double const eta = 0.52 + 0.002 * k;
        csv.row({cell(eta), cell(reference::schultz_crystal(eta)),
                 cell(reference::speedy_crystal(eta)), cell(3 / free_part(eta))});
    }
    return csv;
}

void define_macros(Macros& macros, std::vector<Finding> const& all) {
    double least_order = 1;
    for (Finding const& finding : all) {
        if (finding.quantity == "bond_order")
            least_order = std::min(least_order, finding.comparison.measured.value);
    }
    Finding const& divergence = all.back();
    macros.define("LeastBondOrder", significant(least_order, 2));
    macros.define("LatticeBondOrder", significant(lattice_order, 3));
    macros.define("Divergence", with_error(divergence.comparison.measured));
    macros.define("DivergencePacking", fmt::format("{:.3f}", divergence.at));
    macros.define("MarginPercent", significant(100 * margin, 1));
}

Verdict ask(Experiment& experiment) {
    Findings findings("packing_fraction", "$\\eta$");
    auto const points = runs(experiment.profile());
    std::vector<std::vector<Measurement>> all;
    for (PeriodicRun const& run : points) {
        all.push_back(experiment.campaign().replicates(
            run.text(), replicates, [&](std::uint64_t const seed) { return measure(run, seed); }));
        add_findings(findings, run, all.back());
    }
    findings.add(divergence(points, all));
    experiment.write(csv_of(points, all), "_points");
    experiment.write(curves(), "_theory");
    return findings.conclude(experiment, "Crystal",
                             [&](Macros& macros) { define_macros(macros, findings.all()); });
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask);
}
