#pragma once
// What all experiments have in common: a question goes in, a verdict comes out, results are left
// behind.

#include "validation/records/campaign.hpp"
#include "validation/records/tables.hpp"
#include "validation/statistics/verdict.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace clack::validation {

/// Whether an experiment may be measured by many processes: it may when it hands its state points
/// to the campaign as tasks, before it does anything else.
enum class Processes { one, one_a_state_point };

/// One question asked of the engine.
struct Question {
    std::string stem;   // the name of the experiment's source, data, plot script and figure
    std::string text;   // what is asked
    std::string margin; // what difference would not matter
    std::string reason; // why it would not
    Processes processes = Processes::one;
};

/// How much an experiment runs: quick within minutes, full for the numbers of the report.
enum class Profile { quick, full };

inline char const* name_of(Profile const profile) {
    return profile == Profile::quick ? "quick" : "full";
}

/// What every experiment can be told on its command line.
struct Options {
    Profile profile = Profile::quick;
    std::filesystem::path directory = "build/data"; // where results and the campaign's memory go
    Share share = {};
    int seed_set = 0; // 0 is everybody's; each other one is as good, and independent of it
};

/// The run of an experiment: its options, its memory, and where its results go.
class Experiment {
public:
    Experiment(Question asked, Options options);

    Profile profile() const { return options_.profile; }
    int seed_set() const { return options_.seed_set; } // where starts are not drawn by replicate
    Campaign& campaign() { return campaign_; }

    /// Asks, and what is undecided again, of twice as many replicates each time. Leaves the summary
    /// directory/stem_verdict.csv, and the same as a row of the report's table of verdicts,
    /// stem_verdict.tex: state points, margin, worst z, verdict, cost. A law of nature that was
    /// broken is a verdict too.
    Verdict answer(std::function<Verdict(Experiment&)> const& ask);
    /// How often it has been asked, with this time.
    int look() const { return look_; }
    static constexpr int most_looks = 3;

    /// Write directory/stem<suffix>.csv and directory/stem.tex, under the provenance, and
    /// directory/stem_table.tex, a tabular.
    void write(Csv const& csv, std::string const& suffix = "") const;
    void write(Macros const& macros) const;
    void write_table(std::string const& tabular) const;
    /// Keeps the largest z against agreement of this look, for the summary.
    void note(double z) { worst_z_ = std::max(z, worst_z_); }

private:
    void conclude(Verdict verdict) const;
    void leave(std::string const& ending, std::string const& text) const;

    Question question_;
    Options options_;
    Campaign campaign_;
    int look_ = 1;
    double worst_z_ = 0;
};

/// What an experiment's source defines, and nothing else: the main of all experiments, which the
/// build links to it, runs the two.
extern Question const question;
Verdict ask(Experiment& experiment);

/// Runs an experiment as a program: reads `[--profile quick|full] [-o DIR] [--seeds N]
/// [--list | --point K] [--help]`, asks, prints the verdict.
/// Returns the exit code: 0 agrees (or help was asked for), 1 differs or undecided, or a law of
/// nature was broken; 2 the user's mistake, or a file or another program failed.
int run(int argc, char const* const* argv, Question const& asked,
        std::function<Verdict(Experiment&)> const& ask);

/// Lines `name: value` that say which program on which machine made a result.
std::vector<std::string> provenance(Question const& asked, Profile profile);

} // namespace clack::validation
