#pragma once
// The memory of an experiment: replicates that are finished are never measured again.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace clack::validation {

/// What one replicate of a state point measured, in the order that the experiment gives it.
using Measurement = std::vector<double>;

/// Measures one replicate from its seed.
using Measure = std::function<Measurement(std::uint64_t seed)>;

/// Replicates of state points, kept in a file to which each is appended, flushed, as soon as it is
/// finished: an interrupted campaign goes on where it stopped, losing at most the replicate it was
/// at. The file belongs to one program: one that was built anew starts over.
class Campaign {
public:
    ///   stem        the experiment's name; the file is directory/stem.replicates
    ///   directory   where the file stands or will stand; must exist
    ///   program     what the replicates depend on beside their state point: a hash of the
    ///               executable (program_hash)
    ///   seed_set    which of many independent sets of seeds: 0 is everybody's
    /// A line that an interruption cut short is dropped. Throws InputError when the file cannot be
    /// written.
    Campaign(std::string stem, std::filesystem::path const& directory, std::string const& program,
             int seed_set = 0);

    /// Replicates 0 .. count-1 of a state point, those that the file lacks measured now.
    ///   state_point   a text that says all that the measurement depends on, on one line without
    ///                 the character |
    std::vector<Measurement> replicates(std::string const& state_point, int count,
                                        Measure const& measure);

    /// Replicates that this object measured, not found in the file.
    int measured_count() const { return measured_count_; }

    /// Processor time that the replicates of a state point took, whenever they were measured.  [s]
    double seconds(std::string const& state_point) const;

    /// The same of all replicates that were found in the file instead of being measured.  [s]
    double seconds_recalled() const { return seconds_recalled_; }

    /// State points whose replicates were asked for, in that order.
    std::vector<std::string> const& state_points() const { return asked_for_; }

private:
    struct Replicate {
        Measurement values;
        double seconds;
    };

    void recall(std::string const& header);
    void append(std::string const& line);

    std::string stem_;
    std::string seeded_by_; // the first part of what seeds are hashed from
    std::filesystem::path path_;
    std::map<std::pair<std::string, int>, Replicate> known_;
    std::vector<std::string> asked_for_;
    int measured_count_ = 0;
    double seconds_recalled_ = 0;
};

/// A hash of the executable that is running, in hexadecimal.
std::string program_hash();

} // namespace clack::validation
