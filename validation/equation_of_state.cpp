// Does the pressure of the fluid obey its equation of state, finite-size term included?

#include "validation/equation_of_state.hpp"

#include <algorithm>
#include <cmath>

namespace clack::validation {

using namespace equation_of_state;

Question const question{
    "equation_of_state",
    "Does the pressure of a periodic fluid of hard balls, by virial, by collision rate and by the"
    " contact value of g(r), obey the equations of state of Kolafa, Labik and Malijevsky "
    "(modified) and of Schultz with the 1/N term, and do the three ways to it agree?",
    fmt::format("{} of the collisional part Zc (full profile {}); {} for the contact value (full "
                "profile {})",
                percent(margin(Profile::quick)), percent(margin(Profile::full)),
                percent(contact_margin(Profile::quick)), percent(contact_margin(Profile::full))),
    "two thirds (one third) of what a diameter wrong by 0.1 % does where it does least; the contact"
    " value is extrapolated",
    Processes::one_a_state_point};

namespace {

std::string table_of(std::vector<StatePoint> const& points, Ledger const& ledger) {
    std::vector<std::vector<std::string>> rows;
    for (std::size_t k = 0; k < points.size(); ++k) {
        Entry const* const at = &ledger.entries()[kinds * k];
        std::vector<std::string> row{
            fmt::format("{:.2f}", points[k].packing_fraction), cell(points[k].count),
            with_error(infinite(points[k], by_rate_at(k, ledger))),
            fmt::format("{:.5f}", points[k].expected_of_infinitely_many())};
        for (std::size_t kind = 0; kind < 3; ++kind)
            row.push_back(fmt::format("${:+.1f}$", at[kind].z));
        row.emplace_back(name_of(ledger.verdict_at(at->state)));
        rows.push_back(row);
    }
    return tabular("rrlrrrrl",
                   {"$\\eta$", "$n$", "$Z$", "theory", "virial", "rate", "contact", "verdict"},
                   rows);
}

/// Points and theories for infinitely many balls, for the figure's upper panel.
Csv curves() {
    Csv csv({"packing_fraction", "Z_theory", "Z_carnahan_starling", "Z_schultz"});
    for (int percent = 0; percent <= 50; ++percent) {
        double const eta = percent / 100.0;
        csv.row(eta, reference::modified_klm(eta), reference::carnahan_starling(eta),
                reference::schultz_fluid(eta));
    }
    return csv;
}

Csv infinite_fluid(std::vector<StatePoint> const& points, Ledger const& ledger) {
    Csv csv({"packing_fraction", "Z", "Z_error", "Z_theory", "Z_carnahan_starling"});
    for (std::size_t k = 0; k < points.size(); ++k) {
        double const eta = points[k].packing_fraction;
        csv.row(eta, infinite(points[k], by_rate_at(k, ledger)), reference::modified_klm(eta),
                reference::carnahan_starling(eta));
    }
    return csv;
}

Macros macros_of(std::vector<StatePoint> const& points, double const collisions,
                 Ledger const& ledger, Profile const profile) {
    double largest = 0;       // deviation, in margins, which are parts of Zc
    double largest_error = 0; // 95 %, relative to Z, where the full profile is for the smallest
    for (Entry const& entry : ledger.entries()) {
        Comparison const& c = entry.comparison;
        if (entry.quantity.name == "virial" || entry.quantity.name == "rate")
            largest = std::max(largest, std::abs(c.measured.value - c.reference) / c.margin);
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        Estimate const z = by_rate_at(k, ledger);
        if (aimed_error(points[k].number_density()) == aimed_error(0.5))
            largest_error = std::max(largest_error, half_width(z, 0.95) / z.value);
    }
    Macros macros("EquationOfState");
    macros.define("PackingFractions", cell(points.size()));
    macros.define("Collisions", significant(collisions, 2));
    macros.define("LowestPacking", fmt::format("{:.2f}", points.front().packing_fraction));
    macros.define("HighestPacking", fmt::format("{:.2f}", points.back().packing_fraction));
    macros.define("LargestDeviationPercent", significant(100 * margin(profile) * largest, 2));
    macros.define("LargestRelativeError", significant(largest_error, 2));
    macros.define("AimedError", significant(aimed_error(0.5), 1));
    macros.define("MarginPercent", significant(100 * margin(profile), 1));
    macros.define("ContactMarginPercent", significant(100 * contact_margin(profile), 1));
    return macros;
}

} // namespace

Verdict ask(Experiment& experiment) {
    Profile const profile = experiment.profile();
    auto const points = state_points(profile);
    auto const replicates = experiment.campaign().replicates(tasks_of(points, measure));
    Ledger ledger({Key{"packing_fraction", "$\\eta$"}});
    double collisions = 0;
    double squared_ratio = 0; // of errors by blocking to those over replicates
    for (std::size_t k = 0; k < points.size(); ++k) {
        enter(ledger, points[k], replicates[k], profile);
        collisions += points[k].collisions(replicates[k].size());
        squared_ratio +=
            std::pow(error_by_blocking(replicates[k]) / mean_of(replicates[k], by_virial).error, 2);
    }
    Macros macros = macros_of(points, collisions, ledger, profile);
    macros.define("BlockingRatio",
                  significant(std::sqrt(squared_ratio / static_cast<double>(points.size())), 2));
    Verdict const verdict = conclude(experiment, ledger, std::move(macros));
    experiment.write(curves(), "_theory");
    experiment.write(infinite_fluid(points, ledger), "_infinite");
    experiment.write_table(table_of(points, ledger));
    return verdict;
}

} // namespace clack::validation
