// Does a dilute gas flow as Enskog says, against shear and against compression?

#include "validation/transport.hpp"

#include "validation/harness/experiment.hpp"

namespace clack::validation {

namespace {

using namespace transport;

Question const question{
    "viscosity",
    "Are the shear viscosity and the bulk viscosity of a dilute gas of hard balls, by Helfand's "
    "moments, those of Enskog?",
    "shear: 5 %, a quarter of what collisions add to Boltzmann's value at packing fraction 0.1; "
    "bulk: 15 %, for what Enskog leaves out at packing fraction 0.05"};

Verdict ask(Experiment& experiment) {
    Ledger ledger({{"packing_fraction", "$\\eta$"}, {"count", "$n$"}});
    Macros macros("Viscosity");
    for (StatePoint const& point : state_points(experiment.profile())) {
        auto const seen = experiment.campaign().replicates(
            point.text(), point.replicates,
            [&](std::uint64_t const seed) { return measure(point, seed); });
        enter(ledger, point, seen, shear_viscosity, {"shear", "$\\eta_{\\text{s}}$ / Enskog's"},
              0.05);
        if (point.fluid.packing_fraction > yardstick_max) // in the thinnest gas it is all noise
            enter(ledger, point, seen, bulk_viscosity, {"bulk", "$\\zeta$ / Enskog's"}, 0.15,
                  bulk_yardstick_max);
        if (point.fluid.packing_fraction == 0.49)
            macros.define("NearFreezing", with_error(over_enskog(point, seen, shear_viscosity)));
    }
    return conclude(experiment, ledger, std::move(macros));
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask);
}
