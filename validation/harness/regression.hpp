#pragma once
// Has a change of the code shifted anything that the experiments measure?

#include <filesystem>
#include <string>
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
};

/// All values of the campaign in directory/stem.replicates that have two replicates and are
/// numbers. Nothing where the file is not there.
std::vector<Known> known_of(std::filesystem::path const& directory, std::string const& stem,
                            std::string const& version);

/// The baseline as a file: one row a value. Throws InputError when it cannot be read or written.
std::vector<Known> read_baseline(std::filesystem::path const& path);
void write_baseline(std::filesystem::path const& path, std::vector<Known> const& values,
                    std::vector<std::string> const& header);

/// Those of `values` of which `others` have no counterpart.
std::vector<Known> missing_from(std::vector<Known> const& others, std::vector<Known> const& values);

/// The profile that a table's provenance names; nothing where the table is not there.
std::string profile_of(std::filesystem::path const& table);

/// A value now beside the baseline's.
struct Shift {
    Known before, now;
    double z = 0; // (now - before) in standard errors of the difference
    double p = 1; // Holm-adjusted p-value of "they are draws of one quantity"
};

/// Welch's two-sample t-tests of all values that stand on both sides, with Holm's correction over
/// them, largest |z| first. Values that do not vary on either side shift when they differ at all.
/// The replicates start from the same seeds on both sides: what is remembered of the starts makes
/// the two alike, and the test err on the side of silence.
/// Source: B. L. Welch, Biometrika 34, 28 (1947).
std::vector<Shift> shifts(std::vector<Known> const& before, std::vector<Known> const& now);

/// The risk that any value is said to have shifted though none has.
constexpr double regression_false_alarm = 1e-3;

} // namespace clack::validation
