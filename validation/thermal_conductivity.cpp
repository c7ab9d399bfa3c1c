// Does a dilute gas conduct heat as Enskog says?

#include "validation/transport.hpp"

#include "validation/harness/experiment.hpp"

namespace clack::validation {

namespace {

using namespace transport;

Question const question{
    "thermal_conductivity",
    "Is the thermal conductivity of a dilute gas of hard balls, by Helfand's moment, that of "
    "Enskog?",
    "8 %, a sixth of what collisions add to Boltzmann's value at packing fraction 0.1, and room "
    "for the 1/n of 108 balls"};

Verdict ask(Experiment& experiment) {
    Ledger ledger({{"packing_fraction", "$\\eta$"}, {"count", "$n$"}});
    Macros macros("ThermalConductivity");
    for (StatePoint const& point : state_points(experiment.profile())) {
        auto const seen = experiment.campaign().replicates(
            point.text(), point.replicates,
            [&](std::uint64_t const seed) { return measure(point, seed); });
        enter(ledger, point, seen, thermal_conductivity, {"conductivity", "$\\lambda$ / Enskog's"},
              0.08);
        if (point.fluid.packing_fraction == 0.49)
            macros.define("NearFreezing",
                          with_error(over_enskog(point, seen, thermal_conductivity)));
    }
    return conclude(experiment, ledger, std::move(macros));
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask);
}
