#pragma once
// Has a change of the code shifted anything that the experiments measure?

#include "state/errors.hpp"
#include "validation/records/campaign.hpp"
#include "validation/records/tables.hpp"
#include "validation/statistics/verdict.hpp"

#include <boost/algorithm/string.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace clack::validation {

/// What an experiment's replicates of one state point came to: one of their values.
struct Known {
    std::string experiment, state_point;
    int place = 0; // of the value in the measurement
    double mean = 0;
    double error = 0; // standard error of the mean
    int replicates = 0;
    std::string version; // of the program that measured it

    auto label() const { return std::tie(experiment, state_point, place); }
};

/// The risk that any value is said to have shifted though none has.
constexpr double regression_false_alarm = 1e-3;

/// All values of the campaign in directory/stem.replicates that have two replicates and are
/// numbers. Nothing where the file is not there.
inline std::vector<Known> known_of(std::filesystem::path const& directory, std::string const& stem,
                                   std::string const& version) {
    std::vector<Known> all;
    for (auto const& [state_point, numbered] : recorded(directory / (stem + ".replicates"))) {
        std::vector<Measurement> replicates;
        std::size_t places = std::numeric_limits<std::size_t>::max();
        for (auto const& [number, replicate] : numbered) {
            replicates.push_back(replicate.values);
            places = std::min(places, replicate.values.size());
        }
        for (std::size_t place = 0; place < places && replicates.size() > 1; ++place) {
            Estimate const mean = mean_of(replicates, place);
            if (std::isfinite(mean.value))
                all.push_back({stem, state_point, static_cast<int>(place), mean.value, mean.error,
                               static_cast<int>(replicates.size()), version});
        }
    }
    return all;
}

/// The baseline as a file: one row a value. Throws InputError when it cannot be read or written.
inline std::vector<Known> read_baseline(std::filesystem::path const& path) {
    std::ifstream file(path);
    if (!file) throw InputError(fmt::format("{}: cannot be read", path.string()));
    std::vector<Known> all;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (line.starts_with('#') || line.starts_with("experiment|")) continue;
        std::vector<std::string> cells;
        boost::split(cells, line, boost::is_any_of("|"));
        try {
            all.push_back({cells.at(0), cells.at(1), std::stoi(cells.at(2)), std::stod(cells.at(3)),
                           std::stod(cells.at(4)), std::stoi(cells.at(5)), cells.at(6)});
        } catch (std::logic_error const&) {
            throw InputError(fmt::format("{}:{}: not a row of a baseline", path.string(), number));
        }
    }
    return all;
}

inline void write_baseline(std::filesystem::path const& path, std::vector<Known> const& values,
                           std::vector<std::string> const& header) {
    std::string text;
    for (std::string const& line : header) text += "# " + line + '\n';
    text += "experiment|state_point|place|mean|standard_error|replicates|version\n";
    for (Known const& known : values)
        text += fmt::format("{}|{}|{}|{}|{}|{}|{}\n", known.experiment, known.state_point,
                            known.place, known.mean, known.error, known.replicates, known.version);
    write_file(path, text);
}

/// Those of `values` of which `others` have no counterpart.
inline std::vector<Known> missing_from(std::vector<Known> const& others,
                                       std::vector<Known> const& values) {
    std::vector<Known> missing;
    std::copy_if(
        values.begin(), values.end(), std::back_inserter(missing), [&](Known const& known) {
            return std::none_of(others.begin(), others.end(),
                                [&](Known const& other) { return other.label() == known.label(); });
        });
    return missing;
}

/// The profile that a table's provenance names; nothing where the table is not there.
inline std::string profile_of(std::filesystem::path const& table) {
    constexpr std::string_view mark = "# profile: ";
    std::ifstream file(table);
    for (std::string line; std::getline(file, line) && line.starts_with('#');)
        if (line.starts_with(mark)) return line.substr(mark.size());
    return "";
}

/// A value now beside the baseline's.
struct Shift {
    Known before, now;
    double z = 0; // (now - before) in standard errors of the difference
    double p = 1; // Holm-adjusted p-value of "they are draws of one quantity"
};

/// t and its degrees of freedom, by Welch and Satterthwaite.
inline Shift compared(Known const& before, Known const& now) {
    Shift shift{before, now};
    double const difference = now.mean - before.mean;
    double const a = before.error * before.error, b = now.error * now.error;
    if (difference == 0) return shift;
    if (!(a + b > 0)) {
        shift.z = std::copysign(std::numeric_limits<double>::infinity(), difference);
        shift.p = 0;
        return shift;
    }
    shift.z = difference / std::sqrt(a + b);
    double const freedom =
        (a + b) * (a + b) / (a * a / (before.replicates - 1) + b * b / (now.replicates - 1));
    shift.p = 2 * upper_tail(std::abs(shift.z), freedom);
    return shift;
}

/// Welch's two-sample t-tests of all values that stand on both sides, with Holm's correction over
/// them, largest |z| first. Values that do not vary on either side shift when they differ at all.
/// The replicates start from the same seeds on both sides: what is remembered of the starts makes
/// the two alike, and the test err on the side of silence.
/// Source: B. L. Welch, Biometrika 34, 28 (1947).
inline std::vector<Shift> shifts(std::vector<Known> const& before, std::vector<Known> const& now) {
    std::map<decltype(Known{}.label()), Known const*> by_label;
    for (Known const& known : before) by_label[known.label()] = &known;
    std::vector<Shift> all;
    std::vector<double> p_values;
    for (Known const& known : now) {
        auto const found = by_label.find(known.label());
        if (found == by_label.end()) continue;
        all.push_back(compared(*found->second, known));
        p_values.push_back(all.back().p);
    }
    auto const adjusted = holm(p_values);
    for (std::size_t k = 0; k < all.size(); ++k) all[k].p = adjusted[k];
    std::stable_sort(all.begin(), all.end(),
                     [](Shift const& a, Shift const& b) { return std::abs(a.z) > std::abs(b.z); });
    return all;
}

} // namespace clack::validation
