// What does one more correct digit cost with each method, and where can it no longer be bought?

#include "validation/work_precision.hpp"

#include "simulation/model_choice.hpp"
#include "validation/harness/experiment.hpp"
#include "validation/horizon_limits.hpp"
#include "validation/stepped_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

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

std::vector<double> frame_steps(StatePoint const& point, Profile const profile) {
    std::vector<double> steps{0.3, 0.1, 0.03, 0.01};
    if (point.count < 1000 || profile == Profile::full) steps.insert(steps.end(), {3e-3, 1e-3});
    return steps;
}

std::vector<Softness> softnesses(StatePoint const& point, Profile const profile) {
    if (point.count == 1000 && profile == Profile::quick) return {{1e4, 20}};
    std::vector<Softness> all{{1e4, 10}, {1e4, 50}, {1e5, 20}, {1e6, 20}};
    if (point.count < 1000 && point.packing_fraction > 0.1) all.push_back({1e7, 20});
    return all;
}

/// The engine's lines at a state point: error by type, cost by method and type.
std::vector<Line> engine_lines(StatePoint const& point) {
    std::vector<Line> lines;
    for (Precision const precision : precisions)
        for (Method const method : methods) {
            // The start alone would take seconds.
            bool const slow = method == Method::table && precision == Precision::quadruple;
            if (!(slow && point.count >= 1000))
                lines.push_back({name_of(method), name_of(precision)});
        }
    return lines;
}

void append(Measurement& values, Point const& p) {
    values.insert(values.end(), {p.cost, p.median, p.largest, p.horizon, p.overlap, p.drift,
                                 p.limit, p.tangent_limit});
}

/// All methods go the same way to the last bit, so the errors are those of `fast`.
Measurement measure_engine(StatePoint const& point, std::uint64_t const seed) {
    Scenery const place = scenery(point, seed);
    bool const few = point.count < 1000;
    ErrorGrowth growth = growth_of(place, seed);
    Run const oracle =
        run(place, Method::fast, Precision::quadruple, place.start,
            followed(point, few ? Precision::extended : Precision::double_), &growth);
    std::map<std::string, Point> of_type;
    for (Precision const precision : precisions) {
        bool const is_followed =
            precision < Precision::extended || (few && precision == Precision::extended);
        if (is_followed)
            of_type[name_of(precision)] = point_of(point, place, precision, oracle, growth, seed);
    }
    if (point.with_decimal) {
        double const until = followed(point, Precision::quadruple);
        double const unit = reference::rounding_unit(Precision::quadruple);
        Run const decimal = decimal_run(place, until, 0, seed);
        ErrorGrowth further = growth_of(place, seed);
        Point& quad_point = of_type["quad"];
        quad_point = compare(
            run(place, Method::fast, Precision::quadruple, place.start, until, &further), decimal);
        quad_point.limit =
            matched(decimal.partners, decimal_run(place, until, unit, seed).partners);
        quad_point.tangent_limit = further.limit(unit, seed);
    }
    Measurement values;
    for (Line const& line : engine_lines(point)) {
        Point made = of_type.contains(line.knob) ? of_type[line.knob] : Point{};
        for (Method const method : methods)
            for (Precision const precision : precisions)
                if (line.method == name_of(method) && line.knob == name_of(precision))
                    made.cost = cost(place, method, precision);
        append(values, made);
    }
    return values;
}

/// Frames, then LAMMPS if there is a deck.
Measurement measure_stepped(StatePoint const& point, Profile const profile, std::string const& deck,
                            std::uint64_t const seed) {
    Scenery const place = scenery(point, seed);
    Run const oracle =
        run(place, Method::fast, Precision::quadruple, place.start, spans * final_time);
    Measurement values;
    if (deck.empty()) {
        for (double const step : frame_steps(point, profile))
            append(values, frames_point(place, step, oracle));
    } else {
        for (Point const& p : lammps_points(place, softnesses(point, profile), deck, oracle))
            append(values, p);
    }
    return values;
}

std::vector<Row> rows_of(StatePoint const& point, std::vector<Line> const& lines,
                         std::vector<Measurement> const& replicates) {
    std::vector<Row> rows;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        Row row{point, lines[k], {}};
        for (Measurement const& m : replicates) {
            double const* const v = m.data() + k * point_size;
            row.replicates.push_back({v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]});
        }
        rows.push_back(row);
    }
    return rows;
}

/// The knobs, as a campaign's key tells one profile's from another's.
std::string names_of(std::vector<Line> const& lines) {
    std::string names;
    for (Line const& line : lines) names += (names.empty() ? "" : ",") + line.knob;
    return names;
}

/// LAMMPS missing, or unable to go through with it, leaves its lines out.
void add_lammps(Experiment& experiment, StatePoint const& point, std::vector<Row>& rows) {
    std::vector<Line> lines;
    for (Softness const& soft : softnesses(point, experiment.profile()))
        lines.push_back(
            {"lammps", fmt::format("k={:g};n={:g}", soft.stiffness, soft.steps_per_contact)});
    try {
        std::string const deck = reference::lammps_deck("lammps_cube.in");
        auto const replicates = experiment.campaign().replicates(
            point.text(fmt::format("lammps {} deck={:016x}", names_of(lines), hash_of(deck))), 1,
            [&](std::uint64_t const seed) {
                return measure_stepped(point, experiment.profile(), deck, seed);
            });
        for (Row const& row : rows_of(point, lines, replicates)) rows.push_back(row);
    } catch (reference::LammpsError const& error) {
        std::cout << "without LAMMPS: " << error.what() << '\n';
    }
}

std::vector<Row> measured(Experiment& experiment) {
    std::vector<Row> rows;
    for (StatePoint const& point : state_points(experiment.profile())) {
        auto const add = [&](std::vector<Line> const& lines, std::string const& what,
                             int const replicates, Measure const& measure) {
            for (Row const& row :
                 rows_of(point, lines,
                         experiment.campaign().replicates(point.text(what), replicates, measure)))
                rows.push_back(row);
        };
        add(engine_lines(point), "engine", point.replicates,
            [&](std::uint64_t const seed) { return measure_engine(point, seed); });
        std::vector<Line> frames;
        for (double const step : frame_steps(point, experiment.profile()))
            frames.push_back({"frames", fmt::format("{:g}", step)});
        add(frames, "frames " + names_of(frames), 1, [&](std::uint64_t const seed) {
            return measure_stepped(point, experiment.profile(), "", seed);
        });
        add_lammps(experiment, point, rows);
    }
    return rows;
}

Csv csv_of(std::vector<Row> const& rows) {
    Csv csv({"packing_fraction", "count", "method", "knob", "cpu_seconds_per_ball_and_free_time",
             "median_error_per_diameter", "largest_error_per_diameter",
             "horizon_collisions_per_ball", "horizon_of_rounded_start", "lyapunov_limit",
             "deepest_overlap_per_diameter", "energy_drift", "tangent_limit"});
    for (Row const& row : rows) {
        csv.row({cell(row.point.packing_fraction), cell(row.point.count), row.line.method,
                 row.line.knob, cell(mean(row, &Point::cost)), cell(mean(row, &Point::median)),
                 cell(mean(row, &Point::largest)), cell(mean(row, &Point::horizon)),
                 cell(mean(row, &Point::limit)), cell(line_of(row)),
                 cell(mean(row, &Point::overlap)), cell(mean(row, &Point::drift)),
                 cell(mean(row, &Point::tangent_limit))});
    }
    return csv;
}

} // namespace

Verdict ask(Experiment& experiment) {
    std::vector<Row> const rows = measured(experiment);
    std::vector<Comparison> comparisons;
    for (Precision const precision : precisions)
        comparisons.push_back(shortfall(rows, name_of(precision), &Point::limit,
                                        "the exact motion of a rounded start"));
    for (Precision const precision : precisions)
        comparisons.push_back(shortfall(rows, name_of(precision), &Point::tangent_limit,
                                        "the growth of one rounding in tangent space"));
    comparisons.push_back(gain(rows));
    auto const judgements = judge(comparisons);
    Macros macros("WorkPrecision");
    constexpr std::array names{"Float",        "Double",        "LongDouble",        "Quad",
                               "FloatTangent", "DoubleTangent", "LongDoubleTangent", "QuadTangent",
                               "Gain"};
    for (std::size_t k = 0; k < comparisons.size(); ++k) {
        Comparison const& c = comparisons[k];
        std::cout << fmt::format("{}: {:.3f} +- {:.3f}, expected {} +- {}: z = {:+.1f}  {}\n",
                                 c.name, c.measured.value, c.measured.error, c.reference, c.margin,
                                 judgements[k].z, name_of(judgements[k].verdict));
        macros.define(names[k], with_error(c.measured));
    }
    define_ranges(macros, rows);
    Verdict const verdict = together(judgements);
    macros.define("Profile", name_of(experiment.profile()));
    macros.define("FinalTime", significant(final_time, 2));
    macros.define("Verdict", name_of(verdict));
    experiment.write(csv_of(rows));
    experiment.write(macros);
    return verdict;
}

} // namespace clack::validation
