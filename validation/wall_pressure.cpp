// Do the walls of a cube feel the pressure that theory gives them, by every way of measuring it?

#include "validation/wall_pressure.hpp"

#include <algorithm>
#include <cmath>

namespace clack::validation {

namespace {

using namespace wall_pressure;

Question const question{
    "wall_pressure",
    "Is the force on the walls of a cube that of the bulk's equation of state with the terms of "
    "faces, edges and a fixed number of balls; is it, by the contact theorem, the density of "
    "centres at the walls; and is it exact for two balls?",
    "0.05 % for two balls and 0.1 % where they have little room, four tenths of what walls off by"
    " 0.1 % do (0.2 % for their collisions); 0.3 % for many, three times the error of theory and "
    "less than half of what such walls do to the densest; 2 % where a profile is extrapolated"};

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
        csv.row({cell(point.count), cell(point.side), cell(point.overall_density()),
                 cell(pressure.value), cell(pressure.error), cell(naive(point)), cell(theory.bulk),
                 cell(faces), cell(theory.total()), cell(density.value), cell(density.error),
                 cell(theory.bulk_density)});
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
            csv.row(
                {cell(row.point.count), cell(distances[k]), cell(row.profile[k]), cell(contact)});
    }
    return csv;
}

void define_macros(Macros& macros, std::vector<Row> const& rows) {
    double least = 1, most = 0;
    for (Row const& row : rows) {
        double const short_of = 1 - naive(row.point) / row.pressure.value;
        least = std::min(least, short_of);
        most = std::max(most, short_of);
    }
    macros.define("NaiveLeastPercent", significant(100 * least, 2));
    macros.define("NaiveMostPercent", significant(100 * most, 2));
    macros.define("MarginPercent", significant(100 * margin, 1));
    macros.define("ExtrapolatedMarginPercent", significant(100 * extrapolated_margin, 1));
}

Verdict ask(Experiment& experiment) {
    Findings findings("side_or_overall_density", "$L$ or $n/L^3$");
    std::vector<Row> rows;
    for (StatePoint const& point : state_points(experiment.profile())) {
        auto const replicates = experiment.campaign().replicates(
            point.text(), point.replicates,
            [&](std::uint64_t const seed) { return measure(point, seed); });
        if (point.count == 2) {
            add_exact(findings, point, replicates);
        } else {
            add_cube(findings, point, replicates);
            rows.push_back(row_of(point, replicates));
        }
    }
    experiment.write(csv_of(rows), "_cubes");
    experiment.write(profiles(rows), "_profile");
    return findings.conclude(experiment, "WallPressure",
                             [&](Macros& macros) { define_macros(macros, rows); });
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask);
}
