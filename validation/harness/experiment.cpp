#include "validation/harness/experiment.hpp"

#include "state/errors.hpp"
#include "validation/harness/provenance.hpp"
#include "validation/harness/write_file.hpp"

#include <fmt/format.h>

#include <iostream>

namespace clack::validation {

Experiment::Experiment(Question question, Options options)
    : question_(std::move(question)), options_(std::move(options)),
      campaign_(question_.stem, options_.directory, program_hash()) {}

std::vector<std::string> Experiment::header() const {
    std::vector<std::string> lines = provenance(question_.stem, question_.text, options_);
    lines.push_back("margin: " + question_.margin);
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

int run(int const argc, char const* const* const argv, Question const& question,
        std::function<Verdict(Experiment&)> const& ask) {
    try {
        auto const options = parse_options(argc, argv, question.stem, question.text);
        if (!options) return 0;
        Experiment experiment(question, *options);
        Verdict const verdict = ask(experiment);
        std::cout << fmt::format("{}: {}\n", question.stem, name_of(verdict));
        return exit_code(verdict);
    } catch (InputError const& mistake) {
        std::cerr << fmt::format("{}: {}\n", question.stem, mistake.what());
        return 2;
    } catch (LawBroken const& broken) {
        std::cerr << fmt::format("{}: {}\n", question.stem, broken.what());
        return exit_code(Verdict::differs);
    }
}

} // namespace clack::validation
