// Are the balls of a fluid placed about one another as theory says, near and far?

#include "validation/pair_correlation.hpp"

namespace clack::validation {

namespace {

using namespace pair_correlation;

Question const question{
    "pair_correlation",
    "Does g(r) follow Percus and Yevick where it is right, in a dilute fluid, and Verlet and Weis"
    " in dense ones; is its contact value that of the pressure; and is S(k) for long waves the "
    "compressibility?",
    "1 % of the contact value for itself and for the dilute g(r), 3 % for the dense one, what its"
    " authors leave open; 6 % for long waves, several standard errors"};

struct Row {
    StatePoint point;
    std::vector<Measurement> replicates;
};

/// g bin by bin beside both theories.
Csv distributions(std::vector<Row> const& rows) {
    Csv csv(
        {"packing_fraction", "r_diameters", "g", "g_error", "g_verlet_weis", "g_percus_yevick"});
    for (auto const& [point, replicates] : rows) {
        double const eta = point.run.packing_fraction, end = reach(point.run);
        auto const distances =
            RadialDistribution(point.run.scene(0).system, end, bins(point.run)).distances();
        reference::PercusYevick const closure(eta, end);
        reference::VerletWeis const mended(eta, contact_theory(point.run), end);
        std::size_t value = shells + wave_numbers(point).size();
        for (double const r : distances) {
            Estimate const g = mean_of(replicates, value++);
            csv.row({cell(eta), cell(r), cell(g.value), cell(g.error),
                     cell(mended.radial_distribution(r)), cell(closure.radial_distribution(r))});
        }
    }
    return csv;
}

/// S(k) shell by shell beside the closure, and at k = 0 the compressibility.
Csv waves_of(std::vector<Row> const& rows) {
    Csv csv({"packing_fraction", "k_per_diameter", "S", "S_error", "S_percus_yevick", "S_of_0"});
    for (auto const& [point, replicates] : rows) {
        double const eta = point.run.packing_fraction;
        double const limit = 1 / reference::modified_klm_pressure(point.run.number_density()).slope;
        reference::PercusYevick const closure(eta, 1);
        std::size_t value = shells;
        for (double const k : wave_numbers(point)) {
            Estimate const s = mean_of(replicates, value++);
            csv.row({cell(eta), cell(k), cell(s.value), cell(s.error),
                     cell(closure.structure_factor(k)), cell(limit)});
        }
    }
    return csv;
}

Verdict ask(Experiment& experiment) {
    Findings findings("packing_fraction", "$\\eta$");
    std::vector<Row> rows;
    for (StatePoint const& point : state_points(experiment.profile())) {
        rows.push_back({point, experiment.campaign().replicates(point.text(), point.replicates,
                                                                [&](std::uint64_t const seed) {
                                                                    return measure(point, seed);
                                                                })});
        add_findings(findings, point, rows.back().replicates);
    }
    experiment.write(distributions(rows), "_g");
    experiment.write(waves_of(rows), "_s");
    return findings.conclude(experiment, "PairCorrelation", [](Macros& macros) {
        macros.define("ContactMarginPercent", significant(100 * contact_margin, 1));
        macros.define("DenseMarginPercent", significant(100 * mended_margin, 1));
        macros.define("WaveMarginPercent", significant(100 * wave_margin, 1));
    });
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask);
}
