// Would we notice if the engine were wrong? Each mutant has to be caught.

#include "validation/power.hpp"

#include "validation/harness/experiment.hpp"

#include <fmt/format.h>

#include <iostream>

namespace clack::validation {

using namespace power;

Question const question{
    "power",
    "Is every mutant of the engine, one rule of it exchanged, caught by an experiment at the size "
    "of its quick profile?",
    "none", "each mutant must differ, by the experiment's own margin and risk of a false alarm",
    Processes::one_a_state_point};

namespace {

struct Row {
    Trial trial;
    Outcome outcome;
    double seconds;
    bool stopped; // a law of the engine ended the run

    std::string z() const { return stopped ? "" : fmt::format("{:.3g}", outcome.z); }
};

/// What a law of the engine stopped is caught, with no number to it.
Measurement measure_or_stop(Trial const& trial, std::uint64_t const seed) {
    try {
        return trial.measure(seed);
    } catch (LawBroken const& broken) {
        std::cout << fmt::format("{}: {}\n", trial.mutant, broken.what());
        return {};
    }
}

Row judged(Trial const& trial, std::vector<Measurement> const& replicates, double const seconds) {
    bool const stopped = std::any_of(replicates.begin(), replicates.end(),
                                     [](Measurement const& values) { return values.empty(); });
    return {trial, stopped ? Outcome{Verdict::differs} : trial.judge(replicates), seconds, stopped};
}

Csv csv_of(std::vector<Row> const& rows) {
    Csv csv({"mutant", "experiment", "state_point", "replicates", "z", "stopped_by_a_law",
             "processor_seconds", "verdict"});
    for (Row const& row : rows)
        csv.row({row.trial.mutant, row.trial.experiment, row.trial.state_point,
                 cell(row.trial.replicates), row.z(), row.stopped ? "yes" : "no",
                 fmt::format("{:.2f}", row.seconds), name_of(row.outcome.verdict)});
    return csv;
}

std::string table_of(std::vector<Row> const& rows) {
    std::vector<std::vector<std::string>> cells;
    for (Row const& row : rows)
        cells.push_back({in_tex(row.trial.mutant), "\\texttt{" + in_tex(row.trial.experiment) + "}",
                         row.stopped ? "stopped" : significant(row.outcome.z, 2),
                         fmt::format("{:.1f}", row.seconds),
                         row.outcome.verdict == Verdict::differs ? "yes" : "no"});
    return tabular("llrrl", {"mutant", "experiment", "$z$", "cost, s", "caught"}, cells);
}

} // namespace

Verdict ask(Experiment& experiment) {
    std::vector<Row> rows;
    std::size_t caught = 0, stopped = 0;
    auto const all = trials();
    auto const tasks = tasks_of(all, measure_or_stop);
    auto const replicates = experiment.campaign().replicates(tasks);
    for (std::size_t k = 0; k < all.size(); ++k) {
        Trial const& trial = all[k];
        double const seconds = experiment.campaign().seconds(tasks[k].state_point);
        Row const row = judged(trial, replicates[k], seconds);
        std::cout << fmt::format("{:40} {:22} z = {:8} {:6.2f} s  {}\n", trial.mutant,
                                 trial.experiment, row.stopped ? "stopped" : row.z(), row.seconds,
                                 name_of(row.outcome.verdict));
        caught += row.outcome.verdict == Verdict::differs;
        stopped += row.stopped;
        rows.push_back(row);
    }
    Macros macros("Power");
    macros.define("Mutants", cell(rows.size()));
    macros.define("Caught", cell(caught));
    macros.define("Stopped", cell(stopped));
    experiment.write(csv_of(rows));
    experiment.write(macros);
    experiment.write_table(table_of(rows));
    return caught == rows.size() ? Verdict::agrees : Verdict::differs;
}

} // namespace clack::validation
