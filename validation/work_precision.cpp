// What does one more correct digit cost with each method, and where can it no longer be bought?

#include "validation/harness/ledger.hpp"
#include "validation/horizon_limits.hpp"
#include "validation/stepped_runs.hpp"

#include <iostream>

namespace clack::validation {

using namespace work_precision;

Question const question{
    "work_precision",
    "What does one more correct digit cost with each method, where can it no longer be bought, "
    "and do the engine's floating types last as long as their rounding allows?",
    "horizon: 95 % of that of the exact motion from a start off by one rounding unit, and of that "
    "until such an error, grown in tangent space along the same run, decides whom balls meet; gain "
    "from float to long double over that by the Lyapunov exponent: 1 +- 0.15",
    "exponents fluctuate over the few collisions per ball until a run in a floating type departs "
    "from the oracle's"};

namespace {

std::vector<Row> rows_of(StatePoint const& point, Group const& group,
                         std::vector<Measurement> const& replicates) {
    std::vector<Row> rows;
    for (std::size_t line = 0; line < group.lines.size(); ++line) {
        rows.push_back({point, group.lines[line], {}});
        for (Measurement const& measured : replicates) {
            Point made;
            for (std::size_t k = 0; k < point_values.size(); ++k)
                made.*point_values[k] = measured[line * point_values.size() + k];
            rows.back().replicates.push_back(made);
        }
    }
    return rows;
}

/// LAMMPS missing, or unable to go through with it, leaves its lines out.
std::vector<Row> measured(Experiment& experiment) {
    std::vector<Row> rows;
    for (StatePoint const& point : state_points(experiment.profile()))
        for (Group const& group : groups(point, experiment.profile())) {
            try {
                Task const task{point.text(group.what), group.replicates, group.measure};
                auto const more =
                    rows_of(point, group, experiment.campaign().replicates({task}).front());
                rows.insert(rows.end(), more.begin(), more.end());
            } catch (reference::LammpsError const& error) {
                std::cout << "without LAMMPS: " << error.what() << '\n';
            }
        }
    return rows;
}

Csv points_of(std::vector<Row> const& rows) {
    Csv csv({"packing_fraction", "count", "method", "knob", "cpu_seconds_per_ball_and_free_time",
             "median_error_per_diameter", "largest_error_per_diameter",
             "horizon_collisions_per_ball", "deepest_overlap_per_diameter", "energy_drift",
             "horizon_of_rounded_start", "tangent_limit", "lyapunov_limit"});
    for (Row const& row : rows) {
        std::vector<std::string> cells{cell(row.point.packing_fraction), cell(row.point.count),
                                       row.line.method, row.line.knob};
        for (auto const value : point_values) cells.push_back(cell(mean(row, value)));
        cells.push_back(cell(line_of(row)));
        csv.row(cells);
    }
    return csv;
}

} // namespace

Verdict ask(Experiment& experiment) {
    std::vector<Row> const rows = measured(experiment);
    Ledger ledger({{"type", "type"}});
    Macros macros("WorkPrecision");
    auto const compare = [&](std::string const& type, Quantity const& quantity,
                             std::string const& macro, Comparison const& comparison) {
        ledger.compare({type}, quantity, comparison);
        macros.define(macro, with_error(comparison.measured));
    };
    for (auto const& [precision, macro] : {std::pair{Precision::single_, "Float"},
                                           {Precision::double_, "Double"},
                                           {Precision::extended, "LongDouble"},
                                           {Precision::quadruple, "Quad"}}) {
        std::string const type = name_of(precision), name = macro;
        compare(type, {"short_of_exact_motion", "short of the exact motion"}, name,
                shortfall(rows, type, &Point::limit));
        compare(type, {"short_of_tangent_space", "short of tangent space"}, name + "Tangent",
                shortfall(rows, type, &Point::tangent_limit));
    }
    compare("long double", {"gain_over_float", "gain over float"}, "Gain", gain(rows));
    define_ranges(macros, rows);
    macros.define("FinalTime", significant(final_time, 2));
    experiment.write(points_of(rows), "_points");
    return conclude(experiment, ledger, macros);
}

} // namespace clack::validation
