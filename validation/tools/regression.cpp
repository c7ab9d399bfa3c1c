// Compares what the quick profile has measured with the committed baseline.

#include "validation/tools/regression.hpp"

#include "validation/harness/experiment.hpp"
#include <clack_build.hpp> // made by the build: CLACK_VERSION

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>

namespace clack::validation {

namespace {

struct Request {
    std::string directory = "build/data", baseline = "validation/baseline.csv";
    std::vector<std::string> stems;
    bool renew = false;
};

constexpr std::size_t shown = 20; // rows on the terminal; the file has all

std::vector<Known> measured_now(Request const& request) {
    std::vector<Known> now;
    for (std::string const& stem : request.stems) {
        auto const known = known_of(request.directory, stem, CLACK_VERSION);
        now.insert(now.end(), known.begin(), known.end());
    }
    return now;
}

/// Prints and writes all; returns how many have shifted.
std::size_t tell(std::vector<Shift> const& all, std::string const& directory) {
    Csv csv({"experiment", "state_point", "place", "before", "before_error", "now", "now_error",
             "z", "p_holm"});
    std::size_t shifted = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
        auto const& [old, fresh, z, p] = all[k];
        shifted += p < regression_false_alarm;
        std::string point = old.state_point; // lists in it are parted as the table's cells are
        std::replace(point.begin(), point.end(), ',', ' ');
        csv.row({old.experiment, point, cell(old.place), cell(old.mean), cell(old.error),
                 cell(fresh.mean), cell(fresh.error), cell(z), cell(p)});
        if (k < shown && z != 0)
            std::cout << fmt::format("z = {:+9.3g}  p = {:.1e}  {} {} [{}]: {:.8g} +- {:.2g}, was "
                                     "{:.8g} +- {:.2g}\n",
                                     z, p, old.experiment, old.state_point, old.place, fresh.mean,
                                     fresh.error, old.mean, old.error);
    }
    write_file(std::filesystem::path(directory) / "regression.csv", csv.text({}));
    return shifted;
}

struct Baseline {
    std::vector<Known> compared, others; // of the experiments that were asked for, and the rest
};
Baseline baseline_of(Request const& request) {
    Baseline baseline;
    if (request.renew && !std::filesystem::exists(request.baseline)) return baseline;
    for (Known const& known : read_baseline(request.baseline)) {
        bool const asked = std::find(request.stems.begin(), request.stems.end(),
                                     known.experiment) != request.stems.end();
        (asked ? baseline.compared : baseline.others).push_back(known);
    }
    return baseline;
}

/// Two profiles have no state points in common, or have them with other lengths.
void require_profile(Request const& request) {
    std::string const wanted = profile_of(request.baseline);
    for (std::string const& stem : request.stems) {
        auto const measured =
            profile_of(std::filesystem::path(request.directory) / (stem + "_verdict.csv"));
        if (!wanted.empty() && !measured.empty() && measured != wanted)
            throw InputError(fmt::format("{}: {} is of the profile {}, the baseline {} of {}: "
                                         "measure that one",
                                         request.directory, stem, measured, request.baseline,
                                         wanted));
    }
}

/// One line for each state point of these values.
void tell(std::vector<Known> const& values, char const* const what) {
    std::map<std::pair<std::string, std::string>, int> counts;
    for (Known const& known : values) ++counts[{known.experiment, known.state_point}];
    for (auto const& [point, count] : counts)
        std::cout << fmt::format("{}: {} {}: {} values\n", what, point.first, point.second, count);
}

/// What was measured now beside what the baseline has of other experiments.
void renew(Request const& request, std::vector<Known> values, std::vector<Known> const& others) {
    std::size_t const fresh = values.size();
    values.insert(values.end(), others.begin(), others.end());
    std::stable_sort(values.begin(), values.end(),
                     [](Known const& a, Known const& b) { return a.experiment < b.experiment; });
    auto header = provenance(
        {"all that are judged by chance", "has a change of the code shifted anything?", "", ""},
        Profile::quick);
    header.resize(header.size() - 2); // seeds and margins are the experiments'
    write_baseline(request.baseline, values, header);
    std::cout << fmt::format("{}: {} values written", request.baseline, fresh);
    if (!others.empty()) std::cout << fmt::format(", {} of other experiments kept", others.size());
    std::cout << '\n';
}

int compare(Request const& request) {
    require_profile(request);
    std::vector<Known> const now = measured_now(request);
    auto const [before, others] = baseline_of(request);
    auto const all = shifts(before, now);
    if (all.empty() && !request.renew)
        throw InputError(fmt::format("{}: holds nothing that {} has: measure the experiments first",
                                     request.baseline, request.directory));
    std::size_t const shifted = tell(all, request.directory);
    auto const lost = missing_from(now, before), added = missing_from(before, now);
    tell(lost, "in the baseline, not measured now");
    tell(added, "measured now, not in the baseline");
    std::cout << fmt::format("{} values compared, {} shifted; {} of the baseline not measured now, "
                             "{} new\n",
                             all.size(), shifted, lost.size(), added.size());
    if (request.renew) {
        renew(request, now, others);
        return 0;
    }
    return shifted > 0 || !lost.empty() ? 1 : 0;
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    clack::validation::Request request;
    CLI::App app("Has a change of the code shifted anything that the experiments measure?",
                 "regression");
    app.add_option("experiments", request.stems, "whose replicates are compared");
    app.add_option("-o,--output", request.directory, "folder of the replicates");
    app.add_option("--baseline", request.baseline, "what is compared with")->capture_default_str();
    app.add_flag("--renew", request.renew, "make what is there now the baseline");
    CLI11_PARSE(app, argc, argv);
    try {
        return clack::validation::compare(request);
    } catch (clack::InputError const& mistake) {
        std::cerr << fmt::format("regression: {}\n", mistake.what());
        return 2;
    }
}
