// Are collisions as often, as fast and as oblique as theory says, and free flights as long?

#include "validation/collision_statistics.hpp"

namespace clack::validation {

using namespace collision_statistics;

Question const question{
    "collision_statistics",
    "Are the rate, the normal speed, the impact parameter and the directions of collisions those "
    "of finitely many balls at constant energy, and the free flights of a dilute gas neither "
    "exponential nor their number Poisson's?",
    "0.25 % for the laws of encounters; for free flights half the distance from an exponential law",
    "half of what it does to <b^2> to lose one grazing collision in a hundred",
    Processes::one_a_state_point};

namespace {

/// One of the histograms of all points, with errors from the replicates.
Csv histogram(std::vector<StatePoint> const& points,
              std::vector<std::vector<Measurement>> const& all, std::string const& abscissa,
              std::size_t const first, std::size_t const bins, double const width) {
    Csv csv({"count", "packing_fraction", abscissa, "density", "density_error", "density_theory"});
    for (std::size_t p = 0; p < points.size(); ++p) {
        for (std::size_t k = 0; k < bins; ++k) {
            double const low = static_cast<double>(k) * width;
            // A bin's mean: the law's survival from a random instant has the flight's as its slope.
            using reference::free_flights::time_density;
            double const theory = width == time_bin
                                      ? (time_density(low) + 4 * time_density(low + width / 2) +
                                         time_density(low + width)) /
                                            6
                                      : 1;
            csv.row(points[p].count, points[p].packing_fraction, low + width / 2,
                    mean_of(all[p], first + k), theory);
        }
    }
    return csv;
}

} // namespace

Verdict ask(Experiment& experiment) {
    Ledger ledger({{"boundary", ""}, {"count", "$n$"}, {"packing_fraction", "$\\eta$"}});
    std::vector<StatePoint> const points = state_points(experiment.profile());
    auto const all = experiment.campaign().replicates(tasks_of(points, measure));
    double collisions = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        StatePoint const& point = points[k];
        enter(ledger, point, all[k]);
        collisions += static_cast<double>(all[k].size()) * point.production *
                      static_cast<double>(point.count) / 2;
    }
    experiment.write(
        histogram(points, all, "time_per_mean_free_time", value_count, time_bins, time_bin),
        "_times");
    experiment.write(histogram(points, all, "squared_impact_parameter_per_diameter2",
                               value_count + time_bins, impact_bins, 1.0 / impact_bins),
                     "_impacts");
    Macros macros("CollisionStatistics");
    macros.define("Collisions", significant(collisions, 2));
    macros.define("TimeSquared", significant(reference::free_flights::time_moment(2), 5));
    macros.define("TimeCubed", significant(reference::free_flights::time_moment(3), 5));
    return conclude(experiment, ledger, std::move(macros));
}

} // namespace clack::validation
