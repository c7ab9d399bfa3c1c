#pragma once
// What every experiment can be told on its command line.

#include "validation/harness/campaign.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace clack::validation {

/// How much an experiment runs: quick within minutes, full for the numbers of the report.
enum class Profile { quick, full };

struct Options {
    Profile profile = Profile::quick;
    std::filesystem::path directory = "build/data"; // where results and the campaign's memory go
    Share share;
    int seed_set = 0; // 0 is everybody's; each other one is as good, and independent of it
};

char const* name_of(Profile profile);

/// Reads `[--profile quick|full] [-o DIR] [--seeds N] [--list | --point K] [--help]`; makes the
/// directory.
/// Nothing is returned when help was asked for and printed.
/// Throws InputError for anything else, or for a directory that cannot be made.
std::optional<Options> parse_options(int argc, char const* const* argv, std::string const& stem,
                                     std::string const& question);

} // namespace clack::validation
