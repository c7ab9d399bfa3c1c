// Are the balls of a fluid placed about one another as theory says, near and far?

#include "validation/pair_correlation.hpp"

namespace clack::validation {

using namespace pair_correlation;

constexpr Margins quick = margins(Profile::quick), full = margins(Profile::full);

Question const question{
    "pair_correlation",
    "Does g(r) follow Percus and Yevick where it is right, in a dilute fluid, and Verlet and Weis"
    " in dense ones; is its contact value that of the pressure; and is S(k) for long waves the "
    "compressibility?",
    fmt::format("{} of the contact value for itself (full profile {}); {} for the dilute g(r); {} "
                "for the dense one; {} for long waves (full profile {})",
                percent(quick.contact), percent(full.contact), percent(quick.dilute),
                percent(quick.mended), percent(quick.waves), percent(full.waves)),
    "several standard errors where the profile or the waves are extrapolated; what the authors "
    "leave open for the dense g(r)",
    Processes::one_a_state_point};

namespace {

using All = std::vector<std::vector<Measurement>>;

/// g bin by bin beside both theories.
Csv distributions(std::vector<StatePoint> const& points, All const& all) {
    Csv csv(
        {"packing_fraction", "r_diameters", "g", "g_error", "g_verlet_weis", "g_percus_yevick"});
    for (std::size_t p = 0; p < points.size(); ++p) {
        StatePoint const& point = points[p];
        double const eta = point.packing_fraction, end = reach(point);
        auto const distances =
            RadialDistribution(point.scene(0).system, end, bins(point)).distances();
        reference::PercusYevick const closure(eta, end);
        reference::VerletWeis const mended(eta, contact_theory(point), end);
        std::size_t value = shells + wave_numbers(point).size();
        for (double const r : distances) {
            csv.row(eta, r, mean_of(all[p], value++), mended.radial_distribution(r),
                    closure.radial_distribution(r));
        }
    }
    return csv;
}

/// S(k) shell by shell beside the closure, and at k = 0 the compressibility.
Csv waves_of(std::vector<StatePoint> const& points, All const& all) {
    Csv csv({"packing_fraction", "k_per_diameter", "S", "S_error", "S_percus_yevick", "S_of_0"});
    for (std::size_t p = 0; p < points.size(); ++p) {
        StatePoint const& point = points[p];
        double const eta = point.packing_fraction;
        double const limit = 1 / reference::modified_klm_pressure(point.number_density()).slope;
        reference::PercusYevick const closure(eta, 1);
        std::size_t value = shells;
        for (double const k : wave_numbers(point)) {
            csv.row(eta, k, mean_of(all[p], value++), closure.structure_factor(k), limit);
        }
    }
    return csv;
}

} // namespace

Verdict ask(Experiment& experiment) {
    auto const points = state_points(experiment.profile());
    auto const all = experiment.campaign().replicates(tasks_of(points, measure));
    Margins const allowed = margins(experiment.profile());
    Ledger ledger({Key{"packing_fraction", "$\\eta$"}});
    for (std::size_t k = 0; k < points.size(); ++k) enter(ledger, points[k], all[k], allowed);
    experiment.write(distributions(points, all), "_g");
    experiment.write(waves_of(points, all), "_s");
    Macros macros("PairCorrelation");
    macros.define("ContactMarginPercent", significant(100 * allowed.contact, 1));
    macros.define("DenseMarginPercent", significant(100 * allowed.mended, 1));
    macros.define("WaveMarginPercent", significant(100 * allowed.waves, 1));
    return conclude(experiment, ledger, std::move(macros));
}

} // namespace clack::validation
