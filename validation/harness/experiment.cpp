#include "validation/harness/experiment.hpp"

#include "io/machine.hpp"
#include "state/errors.hpp"
#include "validation/child_process.hpp"
#include <clack_build.hpp> // made by the build: CLACK_VERSION, CLACK_FLAGS

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <fmt/format.h>

#include <iostream>

namespace clack::validation {

namespace {

/// Reads the command line and makes the directory for the results.
Options read_options(CLI::App& app, int const argc, char const* const* const argv) {
    Options options;
    std::string profile = name_of(options.profile);
    app.add_option("--profile", profile, "quick (minutes) or full (the report's numbers)")
        ->check(CLI::IsMember({"quick", "full"}))
        ->capture_default_str();
    app.add_option("-o,--output", options.directory, "directory for the results")
        ->capture_default_str();
    app.add_option("--seeds", options.seed_set, "which of many independent sets of seeds")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    auto* const list = app.add_flag("--list", options.share.listed,
                                    "print the state points that may be shared out");
    app.add_option("--point", options.share.point,
                   "measure this one of them, from 1 on, and judge nothing")
        ->check(CLI::Range(1, 1'000'000))
        ->excludes(list);
    app.parse(argc, argv);
    options.profile = profile == "full" ? Profile::full : Profile::quick;
    std::filesystem::create_directories(options.directory);
    return options;
}

/// The commit of the source tree, asked for when the program runs: compiled in, it would make every
/// commit a new program, whose campaigns start over.
std::string commit() {
    auto const root = std::filesystem::path(CLACK_REFERENCE_DIR).parent_path();
    std::string const answer = output_of(fmt::format(
        "git -C '{}' describe --always --dirty --abbrev=12 2>/dev/null", root.string()));
    return answer.empty() ? "unknown" : answer.substr(0, answer.find('\n'));
}

} // namespace

std::vector<std::string> provenance(Question const& asked, Profile const profile) {
    return {"experiment: " + asked.stem,
            "question: " + asked.text,
            fmt::format("profile: {}", name_of(profile)),
            fmt::format("version: {}", CLACK_VERSION),
            "commit: " + commit(),
            "program: " + program_hash(),
            "compiler: " + compiler(),
            fmt::format("flags: {}", CLACK_FLAGS),
            "machine: " + processor(),
            "seeds: hashed from experiment, state point and replicate; they stand in " +
                asked.stem + ".replicates",
            fmt::format("margin: {}: {}", asked.margin, asked.reason)};
}

Experiment::Experiment(Question asked, Options options)
    : question_(std::move(asked)), options_(std::move(options)),
      campaign_(question_.stem, options_.directory, program_hash(), options_.seed_set,
                options_.share) {}

Verdict Experiment::answer(std::function<Verdict(Experiment&)> const& ask) {
    Verdict verdict = Verdict::differs;
    try {
        for (;; ++look_) {
            worst_z_ = 0;
            verdict = ask(*this);
            if (verdict != Verdict::undecided || look_ == most_looks || !campaign_.lengthen())
                break;
            std::cout << question_.stem << ": undecided: again, with twice as many replicates\n";
        }
    } catch (LawBroken const& broken) {
        std::cerr << fmt::format("{}: {}\n", question_.stem, broken.what());
    }
    conclude(verdict);
    std::cout << fmt::format("{}: {}\n", question_.stem, name_of(verdict));
    return verdict;
}

void Experiment::leave(std::string const& ending, std::string const& text) const {
    write_file(options_.directory / (question_.stem + ending), text);
}

void Experiment::write(Csv const& csv, std::string const& suffix) const {
    leave(suffix + ".csv", csv.text(provenance(question_, options_.profile)));
}

void Experiment::write(Macros const& macros) const {
    leave(".tex", macros.text(provenance(question_, options_.profile)));
}

void Experiment::write_table(std::string const& tabular) const { leave("_table.tex", tabular); }

void Experiment::conclude(Verdict const verdict) const {
    auto const& [stem, text, margin, reason, processes] = question_;
    int const points = campaign_.points_asked_for();
    double const seconds = campaign_.seconds();
    bool const has_z = worst_z_ > 0;
    Csv csv({"experiment", "state_points", "margin", "worst_z", "verdict", "processor_seconds"});
    csv.row(stem, points, boost::replace_all_copy(margin, ",", ";"), // commas part the columns
            has_z ? cell(worst_z_) : "", name_of(verdict), fmt::format("{:.1f}", seconds));
    write(csv, "_verdict");
    leave("_verdict.tex",
          fmt::format("\\texttt{{{}}} & {} & {} & {} & {} & {} \\\\\n", in_tex(stem), points,
                      in_tex(margin), has_z ? significant(worst_z_, 2) : "--", name_of(verdict),
                      significant(seconds, 2)));
}

int run(int const argc, char const* const* const argv, Question const& asked,
        std::function<Verdict(Experiment&)> const& ask) {
    CLI::App app(asked.text, asked.stem);
    try {
        Options const options = read_options(app, argc, argv);
        if (asked.processes == Processes::one) {
            if (options.share.listed) return 0;
            if (options.share.point > 0)
                throw InputError("--point: this experiment cannot be shared out");
        }
        return Experiment(asked, options).answer(ask) == Verdict::agrees ? 0 : 1;
    } catch (ShareDone const&) {
        return 0;
    } catch (CLI::ParseError const& mistake) { // or --help
        if (mistake.get_exit_code() == 0) return app.exit(mistake);
        std::cerr << fmt::format("{}: {}; see {} --help\n", asked.stem, mistake.what(), asked.stem);
    } catch (std::exception const& mistake) { // the user's, a file's, or the experiment's own
        std::cerr << fmt::format("{}: {}\n", asked.stem, mistake.what());
    }
    return 2;
}

} // namespace clack::validation
