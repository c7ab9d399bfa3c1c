// Do balls forget their velocity at the exact rate, then as in a dilute gas, and with the tail that
// the vortices around them leave?

#include "validation/velocity_autocorrelation.hpp"

#include "validation/harness/experiment.hpp"

namespace clack::validation {

using namespace velocity_autocorrelation;

Question const question{
    "velocity_autocorrelation",
    "Does the velocity autocorrelation begin with -2/3 of the collision rate, decay in the dilute"
    " gas as Kac's walk does, and end in the predicted tail?",
    fmt::format("{} of the slope; {} of C(0); {} of the tail (full profile)", percent(slope_margin),
                decay_margin, percent(tail_margin)),
    "what a rate wrong by 1.4 % does to C where it does most; Enskog's coefficients in the tail "
    "and "
    "how it is read",
    Processes::one_a_state_point};

namespace {

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

} // namespace

Verdict ask(Experiment& experiment) {
    Ledger ledger({{"packing_fraction", "$\\eta$"}, {"count", "$n$"}});
    Csv curves({"part", "packing_fraction", "time_per_mean_free_time", "C_over_C0",
                "C_over_C0_error", "C_over_C0_dilute", "tail_in_box", "tail"});
    auto const points = state_points(experiment.profile());
    auto tasks = tasks_of(points, measure);
    for (StatePoint const& point : points)
        if (point.fluid.packing_fraction == dilute)
            tasks.push_back({point.text() + " walk", walk_count,
                             [=](std::uint64_t const seed) { return walk(point, seed); }});
    auto const all = experiment.campaign().replicates(tasks);
    for (std::size_t k = 0, walked = points.size(); k < points.size(); ++k) {
        StatePoint const& point = points[k];
        bool const is_dilute = point.fluid.packing_fraction == dilute;
        auto const walks = is_dilute ? all[walked++] : std::vector<Measurement>{};
        enter(ledger, point, all[k], walks);
        add_curve(curves, point, all[k], walks);
    }
    experiment.write(curves, "_curves");
    return conclude(experiment, ledger, Macros("VelocityAutocorrelation"));
}

} // namespace clack::validation
