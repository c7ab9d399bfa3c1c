// Do the three directions share the energy equally?

#include "validation/equipartition.hpp"

#include "validation/harness/experiment.hpp"

namespace clack::validation {

namespace {

using namespace equipartition;

Question const question{"equipartition",
                        "Do the three directions share the energy of balls between walls equally?",
                        "1 % of a third: a hundredth of what a direction that is left out lacks"};

Verdict ask(Experiment& experiment) {
    auto const replicates = experiment.campaign().replicates(
        tasks_of(state_points, [](StatePoint const& point, std::uint64_t const seed) {
            return measure(point, seed);
        }));
    std::vector<Comparison> shares;
    for (std::size_t k = 0; k < state_points.size(); ++k)
        for (std::size_t axis = 0; axis < 3; ++axis)
            shares.push_back({.name = state_points[k].text(),
                              .measured = mean_of(replicates[k], axis),
                              .reference = 1.0 / 3,
                              .margin = 0.01 / 3});
    auto const judgements = judge(shares);

    Csv csv({"state_point", "share", "share_error", "z", "verdict"});
    for (std::size_t k = 0; k < shares.size(); ++k)
        csv.row({shares[k].name, cell(shares[k].measured.value), cell(shares[k].measured.error),
                 cell(judgements[k].z), name_of(judgements[k].verdict)});
    experiment.write(csv);
    Macros macros("Equipartition");
    macros.define("LargestZ", significant(worst_z_judged().value(), 2));
    macros.define("Verdict", name_of(together(judgements)));
    experiment.write(macros);
    return together(judgements);
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask,
                                  clack::validation::Processes::one_a_state_point);
}
