// Do balls on a line go where the ghosts that pass through one another go, and press as Tonks says?

#include "validation/tonks_gas.hpp"

#include "validation/harness/experiment.hpp"

namespace clack::validation {

using namespace tonks_gas;

Question const question{
    "tonks_gas",
    "Do balls on a line between two walls follow the exact solution by ghosts, and is their "
    "pressure Tonks's?",
    "places: 4 roundings of the side a collision, 16 standard errors of velocities' roundings; "
    "numbers of collisions: 0; pressure: 1 hit of each ghost on each wall",
    "roundings of places at worst all to one side, those of velocities up or down; a hit more or "
    "less than a ghost's due; so all but without a false alarm",
    Processes::one_a_state_point};

namespace {

/// One of the values at one look, over the starts.
Estimate over_starts(std::vector<Measurement> const& replicates, int const look,
                     Value const value) {
    return mean_of(replicates, static_cast<std::size_t>(look) * value_count + value);
}

void add_course(Csv& csv, StatePoint const& point, std::vector<Measurement> const& replicates) {
    for (int k = 0; k < look_count; ++k) {
        double const collisions = over_starts(replicates, k, collisions_per_ball).value;
        Estimate const place = over_starts(replicates, k, place_error);
        Estimate const wall = over_starts(replicates, k, wall_excess);
        csv.row({cell(point.count), point.precision == Precision::single_ ? "float" : "double",
                 cell(look_time(k)), cell(collisions), cell(place.value), cell(place.error),
                 cell(place_bound(point, collisions)), cell(wall.value), cell(wall.error),
                 cell(over_starts(replicates, k, wall_bound).value)});
    }
}

} // namespace

Verdict ask(Experiment& experiment) {
    Ledger ledger({{"count", "$n$"}, {"precision", "precision"}});
    Csv course({"count", "precision", "time", "collisions_per_ball", "place_error_diameters",
                "place_error_error", "place_bound_diameters", "wall_excess", "wall_excess_error",
                "wall_bound"});
    Macros macros("TonksGas");
    double collisions = 0, worst = 0;
    int starts = 0;
    auto const points = state_points(experiment.profile());
    auto const all = experiment.campaign().replicates(tasks_of(
        points, [](StatePoint const& point, std::uint64_t seed) { return measure(point, seed); }));
    for (std::size_t p = 0; p < points.size(); ++p) {
        StatePoint const& point = points[p];
        auto const& replicates = all[p];
        enter(ledger, point, replicates);
        add_course(course, point, replicates);
        starts += point.replicates;
        collisions += over_starts(replicates, look_count - 1, collisions_per_ball).value *
                      static_cast<double>(point.count) / 2 * point.replicates;
        if (point.precision == Precision::single_) continue;
        for (Measurement const& seen : replicates)
            for (int k = 0; k < look_count; ++k)
                worst =
                    std::max(worst, seen[static_cast<std::size_t>(k) * value_count + place_error]);
    }
    experiment.write(course, "_course");
    macros.define("Starts", cell(starts));
    macros.define("Collisions", significant(collisions, 2));
    macros.define("WorstPlace", significant(worst, 2));
    return conclude(experiment, ledger, std::move(macros));
}

} // namespace clack::validation
