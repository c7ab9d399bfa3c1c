// Does a gas carry momentum and heat as Enskog says, and not as Boltzmann does?

#include "validation/transport.hpp"

namespace clack::validation {

using namespace transport;

Question const question{
    "transport",
    "Are the shear viscosity, the bulk viscosity and the thermal conductivity of a gas of hard "
    "balls, by Helfand's moments, those of Enskog, and not Boltzmann's?",
    fmt::format("shear {}; bulk {}; conductivity {}", percent(asked[0].margin),
                percent(asked[1].margin), percent(asked[2].margin)),
    "a quarter and a sixth of what collisions add to Boltzmann's values of the first and the last "
    "at the highest packing fraction that is judged, and room for the 1/n of 108 balls; what "
    "Enskog "
    "leaves out of the bulk viscosity at packing fraction 0.05",
    Processes::one_a_state_point};

Verdict ask(Experiment& experiment) {
    auto const points = state_points(experiment.profile());
    auto const all = experiment.campaign().replicates(tasks_of(points, measure));
    Ledger ledger({{"packing_fraction", "$\\eta$"}, {"count", "$n$"}});
    for (std::size_t k = 0; k < points.size(); ++k) enter(ledger, points[k], all[k]);
    Macros macros("Transport");
    auto const near_freezing = [&](Asked const& of) {
        return with_error(over_enskog(points.back(), all.back(), of));
    };
    macros.define("ShearNearFreezing", near_freezing(asked[shear_viscosity]));
    macros.define("ConductivityNearFreezing", near_freezing(asked[thermal_conductivity]));
    macros.define("JudgedUpTo", cell(judged_up_to));
    macros.define("BoltzmannShear", significant(boltzmann_over_enskog(asked[shear_viscosity]), 2));
    macros.define("BoltzmannConductivity",
                  significant(boltzmann_over_enskog(asked[thermal_conductivity]), 2));
    return conclude(experiment, ledger, std::move(macros));
}

} // namespace clack::validation
