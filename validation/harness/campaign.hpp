#pragma once
// The memory of an experiment: replicates that are finished are never measured again.

#include "validation/harness/interval.hpp"

#include <concepts>
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

/// What part of a campaign this process does.
struct Share {
    enum class Kind {
        all,      // everything that is missing
        list,     // nothing: it prints the tasks
        one_point // one of the tasks, for a process that collects what others have measured
    } kind = Kind::all;
    int point = 0; // from 1 on, of one_point
};

/// Thrown when this process has done its share, and another will judge.
struct ShareDone {};

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
    ///   share       of one point: what it measures goes to a file of its own, which the next
    ///               campaign that does all takes in, so that many may run at once
    /// A line that an interruption cut short is dropped. Throws InputError when the file cannot be
    /// written.
    Campaign(std::string stem, std::filesystem::path const& directory, std::string const& program,
             int seed_set = 0, Share share = {});

    /// The replicates of all tasks, in their order. Those that one process each measured are found
    /// again. Throws ShareDone when the share is not all.
    std::vector<std::vector<Measurement>> replicates(std::vector<Task> const& tasks);

    /// Replicates 0 .. count-1 of a state point, those that the file lacks measured now.
    /// Not to be shared out: throws ShareDone when the share is not all.
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

    std::string recall(std::filesystem::path const& path, std::string const& header);
    std::vector<Measurement> measured(Task const& task);
    void append(std::string const& line);

    std::string stem_;
    std::string seeded_by_; // the first part of what seeds are hashed from
    Share share_;
    std::filesystem::path path_;
    std::map<std::pair<std::string, int>, Replicate> known_;
    std::vector<std::string> asked_for_;
    int measured_count_ = 0;
    double seconds_recalled_ = 0;
};

/// Mean over replicates of one of the values that each measured.
Estimate mean_of(std::vector<Measurement> const& replicates, std::size_t place);

/// Mean over replicates of a function of what each measured.
template <std::invocable<Measurement> Function>
Estimate mean_of(std::vector<Measurement> const& replicates, Function const& function) {
    std::vector<double> values;
    for (Measurement const& measurement : replicates) values.push_back(function(measurement));
    return mean_of(values);
}

/// The replicates in a campaign's file, by state point, in the order of their numbers.
std::map<std::string, std::vector<Measurement>> recorded(std::filesystem::path const& path);

/// A hash of the executable that is running, in hexadecimal.
std::string program_hash();

} // namespace clack::validation
