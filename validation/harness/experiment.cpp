#include "validation/harness/experiment.hpp"

#include "io/machine.hpp"
#include "state/errors.hpp"
#include <clack_build.hpp> // made by the build: CLACK_VERSION, CLACK_FLAGS

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

namespace clack::validation {

namespace {

/// Reads the command line and makes the directory for the results.
Options read_options(CLI::App& app, int const argc, char const* const* const argv) {
    Options options;
    std::string profile = name_of(options.profile), directory = options.directory.string();
    app.add_option("--profile", profile, "quick (minutes) or full (the report's numbers)")
        ->check(CLI::IsMember({"quick", "full"}))
        ->capture_default_str();
    app.add_option("-o,--output", directory, "directory for the results")->capture_default_str();
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
    options.directory = directory;
    std::error_code failure;
    std::filesystem::create_directories(options.directory, failure);
    if (failure)
        throw InputError(
            fmt::format("--output = {}: cannot be made: {}", directory, failure.message()));
    return options;
}

/// The commit of the source tree, asked for when the program runs: compiled in, it would make every
/// commit a new program, whose campaigns start over.
std::string commit() {
    auto const root = std::filesystem::path(CLACK_REFERENCE_DIR).parent_path();
    std::string const command =
        fmt::format("git -C '{}' describe --always --dirty --abbrev=12 2>/dev/null", root.string());
    std::unique_ptr<FILE, int (*)(FILE*)> const pipe(popen(command.c_str(), "r"), pclose);
    char answer[128] = "";
    if (!pipe || !std::fgets(answer, sizeof answer, pipe.get())) return "unknown";
    std::string const line = answer;
    return line.substr(0, line.find('\n'));
}

/// The verdict, or that a law of nature was broken, which is one too.
int judged(Experiment& experiment, std::string const& stem,
           std::function<Verdict(Experiment&)> const& answer) {
    Verdict verdict = Verdict::differs;
    try {
        verdict = answer(experiment);
        while (verdict == Verdict::undecided && experiment.look_again()) {
            std::cout << fmt::format("{}: undecided: again, with twice as many replicates\n", stem);
            verdict = answer(experiment);
        }
    } catch (LawBroken const& broken) {
        std::cerr << fmt::format("{}: {}\n", stem, broken.what());
    }
    experiment.conclude(verdict);
    std::cout << fmt::format("{}: {}\n", stem, name_of(verdict));
    return verdict == Verdict::agrees ? 0 : 1;
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
            fmt::format("seeds: hashed from experiment, state point and replicate; each stands in "
                        "{}.replicates",
                        asked.stem),
            fmt::format("margin: {}: {}", asked.margin, asked.reason)};
}

Experiment::Experiment(Question asked, Options options)
    : question_(std::move(asked)), options_(std::move(options)),
      campaign_(question_.stem, options_.directory, program_hash(), options_.seed_set,
                options_.share) {}

bool Experiment::look_again() {
    if (look_ == most_looks || !campaign_.lengthen()) return false;
    ++look_;
    forget_judged();
    return true;
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
    int const points = campaign_.points_asked_for();
    auto const worst = worst_z_judged();
    double const seconds = campaign_.seconds();
    std::string margin = question_.margin;
    std::replace(margin.begin(), margin.end(), ',', ';'); // which part the columns
    Csv csv({"experiment", "state_points", "margin", "worst_z", "verdict", "processor_seconds"});
    csv.row(question_.stem, points, margin, worst ? cell(*worst) : "", name_of(verdict),
            fmt::format("{:.1f}", seconds));
    write(csv, "_verdict");
    leave("_verdict.tex",
          fmt::format("\\texttt{{{}}} & {} & {} & {} & {} & {} \\\\\n", in_tex(question_.stem),
                      points, in_tex(question_.margin), worst ? significant(*worst, 2) : "--",
                      name_of(verdict), significant(seconds, 2)));
}

int run(int const argc, char const* const* const argv, Question const& asked,
        std::function<Verdict(Experiment&)> const& answer) {
    CLI::App app(asked.text, asked.stem);
    try {
        Options const options = read_options(app, argc, argv);
        bool const whole = asked.processes == Processes::one;
        if (whole && options.share.listed) return 0;
        if (whole && options.share.point > 0)
            throw InputError("--point: this experiment cannot be shared out");
        Experiment experiment(asked, options);
        return judged(experiment, asked.stem, answer);
    } catch (ShareDone const&) {
        return 0;
    } catch (CLI::CallForHelp const&) {
        std::cout << app.help();
        return 0;
    } catch (CLI::ParseError const& mistake) {
        std::cerr << fmt::format("{}: {}; see {} --help\n", asked.stem, mistake.what(), asked.stem);
    } catch (InputError const& mistake) {
        std::cerr << fmt::format("{}: {}\n", asked.stem, mistake.what());
    }
    return 2;
}

} // namespace clack::validation
