#pragma once
// The memory of an experiment: replicates that are finished are never measured again.

#include "validation/statistics/estimate.hpp"

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace clack::validation {

/// A hash of a text: FNV-1a over its bytes with a final avalanche, the same on every machine.
/// Source: G. Fowler, L. C. Noll, K.-P. Vo, draft-eastlake-fnv; the avalanche is splitmix64's
/// (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014, doi:10.1145/2660193.2660195).
std::uint64_t hash_of(std::string_view text);

/// The seed of one replicate of one state point of one experiment. Adding, removing or reordering
/// state points leaves the seeds of all others as they are. Fits a signed 64-bit integer, as the
/// scene file wants it.
std::uint64_t seed_of(std::string_view experiment, std::string_view state_point, int replicate);

/// Measures one replicate from its seed.
using Measure = std::function<Measurement(std::uint64_t seed)>;

/// A state point that is to be measured.
struct Task {
    std::string state_point; // all that the measurement depends on, on one line without |
    int replicates;
    Measure measure;
};

/// The tasks of an experiment's state points: each has text() and replicates.
///   measure   takes a point and a seed
template <class StatePoint, std::invocable<StatePoint, std::uint64_t> MeasurePoint>
std::vector<Task> tasks_of(std::vector<StatePoint> const& points, MeasurePoint const& measure) {
    std::vector<Task> tasks;
    for (StatePoint const& point : points)
        tasks.push_back({point.text(), point.replicates,
                         [=](std::uint64_t const seed) { return measure(point, seed); }});
    return tasks;
}

/// What part of a campaign this process does: all of it, unless one is said.
struct Share {
    bool listed = false; // it prints the tasks
    int point = 0;       // it measures this task, from 1 on, for a process that collects
};

/// Thrown when this process has done its share, and another will judge.
struct ShareDone {};

/// Replicates that are finished, by state point and number.
struct Replicate {
    Measurement values;
    double seconds;   // of processor time
    std::string line; // of the file
};
using Replicates = std::map<std::string, std::map<int, Replicate>>;

/// Those in a campaign's file, but for lines that an interruption cut short. None where its first
/// line is not the header that is asked for.
Replicates recorded(std::filesystem::path const& path, std::string const& header = "");

/// Replicates of state points, kept in a file to which each is appended, flushed, as soon as it is
/// finished: an interrupted campaign goes on where it stopped, losing at most the replicate it was
/// at. The file belongs to one program: one that was built anew starts over.
class Campaign {
public:
    ///   stem        the experiment's name; the file is directory/stem.replicates
    ///   directory   where the file stands or will stand; must exist
    ///   program     what the replicates depend on beside their state point (program_hash)
    ///   seed_set    which of many independent sets of seeds: 0 is everybody's
    ///   share       of one point: what it measures goes to a file of its own, which the next
    ///               campaign that does all takes in, so that many may run at once
    /// Throws InputError when the file cannot be written.
    Campaign(std::string const& stem, std::filesystem::path const& directory,
             std::string const& program, int seed_set = 0, Share share = {});

    /// The replicates of all tasks, in their order. Those that one process each measured are found
    /// again. Throws ShareDone when the share is not all.
    std::vector<std::vector<Measurement>> replicates(std::vector<Task> const& tasks);

    /// Replicates 0 .. count-1 of a state point, those that the file lacks measured now.
    /// Not to be shared out: throws ShareDone when the share is not all.
    std::vector<Measurement> replicates(std::string const& state_point, int count,
                                        Measure const& measure);

    /// Processor time that the replicates of a state point took, whenever they were measured.  [s]
    double seconds(std::string const& state_point) const;

    /// Processor time that this campaign has taken in all, of this process, of those that it has
    /// started and for the replicates that were found in the file.  [s]
    double seconds() const;

    /// State points whose replicates were asked for.
    int points_asked_for() const { return static_cast<int>(asked_for_.size()); }

    /// From now on each task has twice as many replicates, those of before among them. False where
    /// no tasks were asked for, which alone can be told so.
    bool lengthen();

private:
    void take_in(std::filesystem::path const& path);
    void save() const;
    std::vector<Measurement> measured(Task const& task);

    std::string seeded_by_; // the first part of what seeds are hashed from
    std::string header_;    // the file's first line
    Share share_;
    std::filesystem::path path_;
    Replicates known_;
    int times_as_many_ = 1;
    bool has_tasks_ = false;
    std::map<std::string, int> asked_for_; // replicates of each state point
    double seconds_recalled_ = 0;
};

/// A hash of the executable that is running, in hexadecimal.
std::string program_hash();

} // namespace clack::validation
