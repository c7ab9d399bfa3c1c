// Do the walls of a cube feel the pressure that theory gives them, by every way of measuring it?

#include "validation/wall_pressure.hpp"

#include <algorithm>
#include <cmath>

namespace clack::validation {

using namespace wall_pressure;

constexpr Margins quick = margins(Profile::quick), full = margins(Profile::full);

Question const question{
    "wall_pressure",
    "Is the force on the walls of a cube that of the bulk's equation of state with the terms of "
    "faces, edges and a fixed number of balls; is it, by the contact theorem, the density of "
    "centres at the walls; and is it exact for two balls?",
    fmt::format(
        "two balls {} or, with little room, {} (full profile {} and {}); their collisions {} "
        "({}); many {}; {} where a profile is extrapolated ({})",
        percent(quick.two_balls), percent(quick.two_with_little_room), percent(full.two_balls),
        percent(full.two_with_little_room), percent(quick.two_collisions),
        percent(full.two_collisions), percent(quick.many), percent(quick.extrapolated),
        percent(full.extrapolated)),
    "four tenths of what walls off by 0.1 % do to two balls; three times the error of theory and "
    "less than half of what such walls do to the densest; several standard errors",
    Processes::one_a_state_point};

namespace {

/// Pressure of a cube of many balls and what theory makes of it, term after term.
struct Row {
    StatePoint point;
    Estimate pressure, bulk_density;
    reference::WalledCubePressure theory;
    std::vector<double> profile;
};

Row row_of(StatePoint const& point, std::vector<Measurement> const& replicates) {
    Row row{point,
            mean_of(replicates, by_impulse),
            mean_of(replicates, bulk_density),
            theory_of(point),
            {}};
    for (std::size_t k = 0; k < bins_of_profile; ++k)
        row.profile.push_back(mean_of(replicates, profile + k).value);
    return row;
}

double naive(StatePoint const& point) {
    return reference::modified_klm_pressure(point.overall_density()).value;
}

Csv csv_of(std::vector<Row> const& rows) {
    Csv csv({"count", "side_diameters", "overall_density_per_diameter3", "P", "P_error",
             "P_of_overall_density", "P_of_bulk", "P_with_faces", "P_with_edges",
             "bulk_density_per_diameter3", "bulk_density_error", "bulk_density_theory"});
    for (auto const& [point, pressure, density, theory, values] : rows) {
        double const faces = theory.bulk + theory.faces + theory.canonical;
        csv.row(point.count, point.side, point.overall_density(), pressure, naive(point),
                theory.bulk, faces, theory.total(), density, theory.bulk_density);
    }
    return csv;
}

/// Density against distance from a wall, over the middle of the faces.
Csv profiles(std::vector<Row> const& rows) {
    Csv csv({"count", "distance_diameters", "density_per_diameter3", "contact_theory"});
    for (Row const& row : rows) {
        auto const distances =
            DensityProfile(scene_of(row.point, 0).system, 3.5, bins_of_profile, edge_width)
                .distances();
        double const contact = reference::modified_klm_pressure(row.bulk_density.value).value;
        for (std::size_t k = 0; k < distances.size(); ++k)
            csv.row(row.point.count, distances[k], row.profile[k], contact);
    }
    return csv;
}

Macros macros_of(std::vector<Row> const& rows) {
    double least = 1, most = 0;
    for (Row const& row : rows) {
        double const short_of = 1 - naive(row.point) / row.pressure.value;
        least = std::min(least, short_of);
        most = std::max(most, short_of);
    }
    Macros macros("WallPressure");
    macros.define("NaiveLeastPercent", significant(100 * least, 2));
    macros.define("NaiveMostPercent", significant(100 * most, 2));
    return macros;
}

} // namespace

Verdict ask(Experiment& experiment) {
    auto const points = state_points(experiment.profile());
    auto const all = experiment.campaign().replicates(tasks_of(points, measure));
    Margins const allowed = margins(experiment.profile());
    Ledger ledger({Key{"side_or_overall_density", "$L$ or $n/L^3$"}});
    std::vector<Row> rows;
    for (std::size_t k = 0; k < points.size(); ++k) {
        enter(ledger, points[k], all[k], allowed);
        if (points[k].count > 2) rows.push_back(row_of(points[k], all[k]));
    }
    experiment.write(csv_of(rows), "_cubes");
    experiment.write(profiles(rows), "_profile");
    return conclude(experiment, ledger, macros_of(rows));
}

} // namespace clack::validation
