#include "validation/harness/regression.hpp"

#include "state/errors.hpp"
#include "validation/harness/campaign.hpp"
#include "validation/harness/interval.hpp"
#include "validation/harness/many_tests.hpp"
#include "validation/harness/write_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <tuple>

namespace clack::validation {

namespace {

using Label = std::tuple<std::string, std::string, int>;

Label label_of(Known const& known) { return {known.experiment, known.state_point, known.place}; }

/// t and its degrees of freedom, by Welch and Satterthwaite.
Shift compared(Known const& before, Known const& now) {
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

} // namespace

std::vector<Known> known_of(std::filesystem::path const& directory, std::string const& stem,
                            std::string const& version) {
    std::vector<Known> all;
    for (auto const& [state_point, replicates] : recorded(directory / (stem + ".replicates"))) {
        std::size_t places = replicates.front().size();
        for (Measurement const& values : replicates) places = std::min(places, values.size());
        for (std::size_t place = 0; place < places && replicates.size() > 1; ++place) {
            std::vector<double> values;
            for (Measurement const& measurement : replicates) values.push_back(measurement[place]);
            Estimate const mean = mean_of(values);
            if (!std::isfinite(mean.value)) continue;
            all.push_back({stem, state_point, static_cast<int>(place), mean.value, mean.error,
                           static_cast<int>(values.size()), version});
        }
    }
    return all;
}

std::vector<Known> read_baseline(std::filesystem::path const& path) {
    std::ifstream file(path);
    if (!file) throw InputError(fmt::format("{}: cannot be read", path.string()));
    std::vector<Known> all;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        if (line.starts_with('#') || line.starts_with("experiment|")) continue;
        std::istringstream cells(line);
        std::string place, mean, error, replicates;
        Known known;
        for (std::string* cell : {&known.experiment, &known.state_point, &place, &mean, &error,
                                  &replicates, &known.version})
            std::getline(cells, *cell, '|');
        try {
            known.place = std::stoi(place);
            known.mean = std::stod(mean);
            known.error = std::stod(error);
            known.replicates = std::stoi(replicates);
        } catch (std::logic_error const&) {
            throw InputError(fmt::format("{}:{}: not a row of a baseline", path.string(), number));
        }
        all.push_back(known);
    }
    return all;
}

void write_baseline(std::filesystem::path const& path, std::vector<Known> const& values,
                    std::vector<std::string> const& header) {
    std::string text;
    for (std::string const& line : header) text += "# " + line + '\n';
    text += "experiment|state_point|place|mean|standard_error|replicates|version\n";
    for (Known const& known : values)
        text += fmt::format("{}|{}|{}|{}|{}|{}|{}\n", known.experiment, known.state_point,
                            known.place, known.mean, known.error, known.replicates, known.version);
    write_file(path, text);
}

std::vector<Known> missing_from(std::vector<Known> const& others,
                                std::vector<Known> const& values) {
    std::set<Label> there;
    for (Known const& known : others) there.insert(label_of(known));
    std::vector<Known> missing;
    std::copy_if(values.begin(), values.end(), std::back_inserter(missing),
                 [&](Known const& known) { return !there.contains(label_of(known)); });
    return missing;
}

std::string profile_of(std::filesystem::path const& table) {
    constexpr std::string_view mark = "# profile: ";
    std::ifstream file(table);
    for (std::string line; std::getline(file, line) && line.starts_with('#');)
        if (line.starts_with(mark)) return line.substr(mark.size());
    return "";
}

std::vector<Shift> shifts(std::vector<Known> const& before, std::vector<Known> const& now) {
    std::map<Label, Known> by_label;
    for (Known const& known : before) by_label[label_of(known)] = known;
    std::vector<Shift> all;
    std::vector<double> p_values;
    for (Known const& known : now) {
        auto const found = by_label.find(label_of(known));
        if (found == by_label.end()) continue;
        all.push_back(compared(found->second, known));
        p_values.push_back(all.back().p);
    }
    auto const adjusted = holm(p_values);
    for (std::size_t k = 0; k < all.size(); ++k) all[k].p = adjusted[k];
    std::stable_sort(all.begin(), all.end(),
                     [](Shift const& a, Shift const& b) { return std::abs(a.z) > std::abs(b.z); });
    return all;
}

} // namespace clack::validation
