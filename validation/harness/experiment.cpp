#include "validation/harness/experiment.hpp"

#include "state/errors.hpp"
#include "validation/harness/processor_time.hpp"
#include "validation/harness/provenance.hpp"
#include "validation/harness/write_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace clack::validation {

namespace {

/// A law of nature that was broken is a verdict too.
Verdict answer_or_break(Experiment& experiment, std::function<Verdict(Experiment&)> const& answer) {
    try {
        return answer(experiment);
    } catch (LawBroken const& broken) {
        std::cerr << fmt::format("{}: {}\n", experiment.stem(), broken.what());
        return Verdict::differs;
    }
}

} // namespace

Experiment::Experiment(Question asked, Options options)
    : question_(std::move(asked)), options_(std::move(options)),
      campaign_(question_.stem, options_.directory, program_hash(), options_.seed_set,
                options_.share) {}

std::vector<std::string> Experiment::header() const {
    std::vector<std::string> lines = provenance(question_.stem, question_.text, options_);
    lines.push_back("margin: " + question_.margin + ": " + question_.reason);
    return lines;
}

void Experiment::write(Csv const& csv, std::string const& suffix) const {
    write_file(options_.directory / (question_.stem + suffix + ".csv"), csv.text(header()));
}

void Experiment::write(Macros const& macros) const {
    write_file(options_.directory / (question_.stem + ".tex"), macros.text(header()));
}

void Experiment::write_table(std::string const& tabular) const {
    write_file(options_.directory / (question_.stem + "_table.tex"), tabular);
}

void Experiment::conclude(Verdict const verdict) const {
    auto const points = campaign_.state_points().size();
    auto const worst = worst_z_judged();
    double const seconds = processor_seconds_in_all() + campaign_.seconds_recalled();
    std::string margin = question_.margin;
    std::replace(margin.begin(), margin.end(), ',', ';'); // which part the columns
    Csv csv({"experiment", "state_points", "margin", "worst_z", "verdict", "processor_seconds"});
    csv.row({question_.stem, cell(points), margin, worst ? cell(*worst) : "", name_of(verdict),
             fmt::format("{:.1f}", seconds)});
    write(csv, "_verdict");
    write_file(options_.directory / (question_.stem + "_verdict.tex"),
               fmt::format("\\texttt{{{}}} & {} & {} & {} & {} & {} \\\\\n", in_tex(question_.stem),
                           points, in_tex(question_.margin), worst ? significant(*worst, 2) : "--",
                           name_of(verdict), significant(seconds, 2)));
}

int run(int const argc, char const* const* const argv, Question const& asked,
        std::function<Verdict(Experiment&)> const& answer) {
    try {
        auto const options = parse_options(argc, argv, asked.stem, asked.text);
        if (!options) return 0;
        if (asked.processes == Processes::one && options->share.kind != Share::Kind::all) {
            if (options->share.kind == Share::Kind::list) return 0;
            throw InputError("--point: this experiment cannot be shared out");
        }
        Experiment experiment(asked, *options);
        Verdict const verdict = answer_or_break(experiment, answer);
        experiment.conclude(verdict);
        std::cout << fmt::format("{}: {}\n", asked.stem, name_of(verdict));
        return exit_code(verdict);
    } catch (ShareDone const&) {
        return 0;
    } catch (InputError const& mistake) {
        std::cerr << fmt::format("{}: {}\n", asked.stem, mistake.what());
        return 2;
    }
}

} // namespace clack::validation
