// Do balls forget their velocity at the exact rate, then as in a dilute gas, and with the tail that
// the vortices around them leave?

#include "validation/velocity_autocorrelation.hpp"

#include "validation/harness/experiment.hpp"

namespace clack::validation {

namespace {

using namespace velocity_autocorrelation;

Question const question{
    "velocity_autocorrelation",
    "Does the velocity autocorrelation begin with -2/3 of the collision rate, decay in the dilute"
    " gas as Kac's walk does, and end in the predicted tail?",
    "1.5 % of the slope; 0.005 of C(0), what a rate wrong by 1.4 % does; a third of the tail, "
    "which is judged in the full profile, for Enskog's coefficients in it"};

void add_curve(Csv& csv, StatePoint const& point, std::vector<Measurement> const& seen,
               std::vector<Measurement> const& walks) {
    Watch const watch = point.watch();
    for (std::size_t lag = 0; lag < seen.front().size(); ++lag) {
        double const time = static_cast<double>(lag) * watch.interval;
        Estimate const found = mean_of(seen, lag);
        double const infinite =
            time > 0 ? reference::long_time_tail(
                           point.fluid.number_density(),
                           reference::Enskog(point.fluid.packing_fraction).self_diffusion,
                           reference::Enskog(point.fluid.packing_fraction).shear_viscosity,
                           time / point.fluid.collision_rate())
                     : 1;
        csv.row({point.part == Part::tail ? "tail" : "decay", cell(point.fluid.packing_fraction),
                 cell(time), cell(found.value), cell(found.error),
                 cell(walks.empty() ? std::exp(-2 * time / 3) : mean_of(walks, lag).value),
                 cell(time > 0 ? tail(point.fluid, time) : 1), cell(infinite)});
    }
}

Verdict ask(Experiment& experiment) {
    Ledger ledger({{"packing_fraction", "$\\eta$"}, {"count", "$n$"}});
    Csv curves({"part", "packing_fraction", "time_per_mean_free_time", "C_over_C0",
                "C_over_C0_error", "C_over_C0_dilute", "tail_in_box", "tail"});
    for (StatePoint const& point : state_points(experiment.profile())) {
        auto const seen = experiment.campaign().replicates(
            point.text(), point.replicates,
            [&](std::uint64_t const seed) { return measure(point, seed); });
        std::vector<Measurement> walks;
        if (point.fluid.packing_fraction == dilute)
            walks = experiment.campaign().replicates(
                point.text() + " walk", walk_count,
                [&](std::uint64_t const seed) { return walk(point, seed); });
        enter(ledger, point, seen, walks);
        add_curve(curves, point, seen, walks);
    }
    experiment.write(curves, "_curves");
    return conclude(experiment, ledger, Macros("VelocityAutocorrelation"));
}

} // namespace

} // namespace clack::validation

int main(int argc, char** argv) {
    return clack::validation::run(argc, argv, clack::validation::question, clack::validation::ask);
}
