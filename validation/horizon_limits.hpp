#pragma once
// How far the engine's floating types last beside the limits of their rounding: what
// work_precision judges, and what it tells of the distance to the drawn lines.

#include "validation/records/tables.hpp"
#include "validation/statistics/verdict.hpp"
#include "validation/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace clack::validation::work_precision {

constexpr double horizon_margin = 0.05, gain_margin = 0.15;

/// One line of the table: a method with its knob at a state point, all replicates.
struct Row {
    StatePoint point;
    Line line;
    std::vector<Point> replicates;
};

inline double mean(Row const& row, double Point::*const value) {
    double sum = 0;
    for (Point const& p : row.replicates) sum += p.*value;
    return sum / static_cast<double>(row.replicates.size());
}

/// The drawn line: collisions until an error of the rounding unit is a diameter; -1 for other
/// lines.
inline double line_of(Row const& row) {
    for (Precision const precision : precisions)
        if (row.line.knob == name_of(precision))
            return row.point.limit(reference::rounding_unit(precision));
    return -1;
}

/// How far the horizon of a type falls short of a limit; lasting longer is no fault.
inline Comparison shortfall(std::vector<Row> const& rows, std::string const& type,
                            double Point::*limit) {
    std::vector<double> ratios;
    for (Row const& row : rows)
        if (row.line.method == "fast" && row.line.knob == type)
            for (Point const& p : row.replicates)
                if (p.*limit > 0) ratios.push_back(p.horizon / (p.*limit));
    Estimate short_of = mean_of(ratios);
    short_of.value = std::max(1 - short_of.value, 0.0);
    return {.measured = short_of, .margin = horizon_margin};
}

/// A ratio in all cells of one packing fraction where a horizon was measured, least and largest:
/// "0.94 to 1.02".
inline std::string range_of(std::vector<Row> const& rows, double const packing_fraction,
                            std::function<double(Row const&)> const& ratio) {
    double least = infinity<double>, largest = 0;
    for (Row const& row : rows) {
        bool const asked = row.line.method == "fast" && mean(row, &Point::horizon) > 0 &&
                           row.point.packing_fraction == packing_fraction;
        if (!asked) continue;
        least = std::min(least, ratio(row));
        largest = std::max(largest, ratio(row));
    }
    return fmt::format("{:.2f} to {:.2f}", least, largest);
}

/// The distances to the plain line and to the limit by tangent space: of the engine, and of the
/// exact motion of a rounded start. Ranges over types and numbers of balls.
inline void define_ranges(Macros& macros, std::vector<Row> const& rows) {
    for (auto const& part : {std::pair{"Dilute", 0.05}, {"Middle", 0.2}, {"Dense", 0.4}}) {
        auto const define = [&](std::string const& which, auto const& ratio) {
            macros.define(part.first + which, range_of(rows, part.second, ratio));
        };
        define("OfLine", [](Row const& row) { return mean(row, &Point::horizon) / line_of(row); });
        define("ExactOfLine",
               [](Row const& row) { return mean(row, &Point::limit) / line_of(row); });
        define("OfTangent", [](Row const& row) {
            return mean(row, &Point::horizon) / mean(row, &Point::tangent_limit);
        });
    }
}

/// What the digits from float to long double gain over what the exponent says they should.
inline Comparison gain(std::vector<Row> const& rows) {
    std::vector<double> ratios;
    for (Row const& one : rows)
        for (Row const& other : rows)
            if (one.line.method == "fast" && one.line.knob == "float" &&
                other.line.method == "fast" && other.line.knob == "long double" &&
                one.point.count == other.point.count && other.point.count < 1000 &&
                one.point.packing_fraction == other.point.packing_fraction)
                for (std::size_t r = 0; r < one.replicates.size(); ++r)
                    ratios.push_back(
                        (other.replicates[r].horizon - one.replicates[r].horizon) /
                        (other.point.limit(reference::rounding_unit(Precision::extended)) -
                         one.point.limit(reference::rounding_unit(Precision::single_))));
    return {.measured = mean_of(ratios), .reference = 1, .margin = gain_margin};
}

} // namespace clack::validation::work_precision
