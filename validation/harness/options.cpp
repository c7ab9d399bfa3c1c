#include "validation/harness/options.hpp"

#include "state/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <iostream>

namespace clack::validation {

char const* name_of(Profile const profile) { return profile == Profile::quick ? "quick" : "full"; }

std::optional<Options> parse_options(int const argc, char const* const* const argv,
                                     std::string const& stem, std::string const& question) {
    Options options;
    std::string profile = name_of(options.profile);
    std::string directory = options.directory.string();
    bool listed = false;
    CLI::App app(question, stem);
    app.add_option("--profile", profile, "quick (minutes) or full (the report's numbers)")
        ->check(CLI::IsMember({"quick", "full"}))
        ->capture_default_str();
    app.add_option("-o,--output", directory, "directory for the results")->capture_default_str();
    app.add_option("--seeds", options.seed_set, "which of many independent sets of seeds")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    auto* const list =
        app.add_flag("--list", listed, "print the state points that may be shared out");
    auto* const point = app.add_option("--point", options.share.point,
                                       "measure this one of them, from 1 on, and judge nothing");
    point->excludes(list);
    try {
        app.parse(argc, argv);
    } catch (CLI::CallForHelp const&) {
        std::cout << app.help();
        return std::nullopt;
    } catch (CLI::ParseError const& error) {
        throw InputError(fmt::format("{}; see {} --help", error.what(), stem));
    }
    if (listed) options.share.kind = Share::Kind::list;
    if (*point) options.share.kind = Share::Kind::one_point;
    options.profile = profile == "full" ? Profile::full : Profile::quick;
    options.directory = directory;
    std::error_code failure;
    std::filesystem::create_directories(options.directory, failure);
    if (failure) {
        throw InputError(
            fmt::format("--output = {}: cannot be made: {}", directory, failure.message()));
    }
    return options;
}

} // namespace clack::validation
