// Do the three directions share the energy equally?

#include "validation/equipartition.hpp"

namespace clack::validation {

using namespace equipartition;

Question const question{
    "equipartition", "Do the three directions share the energy of balls between walls equally?",
    percent(margin) + " of a third", "a hundredth of what a direction that is left out lacks",
    Processes::one_a_state_point};

Verdict ask(Experiment& experiment) {
    auto const replicates = experiment.campaign().replicates(tasks_of(state_points, measure));
    Ledger ledger({{"packing_fraction", "$\\eta$"}, {"axis", "axis"}});
    for (std::size_t k = 0; k < state_points.size(); ++k)
        enter(ledger, state_points[k], replicates[k]);
    return conclude(experiment, ledger, Macros("Equipartition"));
}

} // namespace clack::validation
