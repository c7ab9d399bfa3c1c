// Do balls diffuse as their velocities say, as Enskog says where he is right, and as the size of
// the box says?

#include "validation/self_diffusion.hpp"

#include "validation/harness/experiment.hpp"

namespace clack::validation {

using namespace self_diffusion;

Question const question{
    "self_diffusion",
    "Do displacements and velocities give the same self-diffusion, is it Enskog's in the dilute "
    "gas, and does it grow with the box as the hydrodynamics of its images says?",
    fmt::format(
        "{} between the routes; {} of Enskog's value in the dilute gas; {} of the slope with "
        "1/side",
        percent(route_margin), percent(dilute_margin), percent(slope_margin)),
    "the tenth part of what a fluid adds to Enskog's value; half of what Sonine's polynomials "
    "beyond "
    "the first add; what Enskog's viscosity and the next power of 1/side may be off",
    Processes::one_a_state_point};

namespace {

Csv curve() {
    Csv csv({"packing_fraction", "D_speedy_over_enskog"});
    for (int percent = 1; percent <= 50; ++percent) {
        double const eta = percent / 100.0;
        double const rho = PeriodicFluid{eta, 2}.number_density();
        csv.row({cell(eta), cell(reference::speedy_self_diffusion(rho) /
                                 reference::Enskog(eta).self_diffusion)});
    }
    return csv;
}

void add_point(Csv& csv, StatePoint const& point, std::vector<Measurement> const& seen) {
    double const unit = reference::Enskog(point.fluid.packing_fraction).self_diffusion;
    Estimate const by_way = mean_of(seen, einstein), by_memory = mean_of(seen, green_kubo);
    Estimate const infinite = extrapolated(point.fluid, seen);
    csv.row({cell(point.fluid.packing_fraction), cell(point.fluid.count), cell(by_way.value),
             cell(by_way.error), cell(by_memory.value), cell(by_memory.error), cell(unit),
             cell(deficit(point.fluid, seen)), cell(infinite.value), cell(infinite.error),
             cell(1 / point.fluid.side())});
}

} // namespace

Verdict ask(Experiment& experiment) {
    Ledger ledger({{"packing_fraction", "$\\eta$"}, {"count", "$n$"}});
    Csv values({"packing_fraction", "count", "D_einstein", "D_einstein_error", "D_green_kubo",
                "D_green_kubo_error", "D_enskog", "deficit", "D_infinite_over_enskog",
                "D_infinite_over_enskog_error", "inverse_side_per_diameter"});
    std::vector<StatePoint> sizes;
    std::vector<std::vector<Measurement>> of_size;
    Macros macros("SelfDiffusion");
    auto const points = state_points(experiment.profile());
    auto const all = experiment.campaign().replicates(tasks_of(points, measure));
    for (std::size_t k = 0; k < points.size(); ++k) {
        StatePoint const& point = points[k];
        auto const& seen = all[k];
        enter(ledger, point, seen);
        add_point(values, point, seen);
        if (point.fluid.packing_fraction != of_sizes) continue;
        sizes.push_back(point);
        of_size.push_back(seen);
        macros.define(point.fluid.count == 108   ? "Smallest"
                      : point.fluid.count == 256 ? "Middle"
                                                 : "Largest",
                      with_error(extrapolated(point.fluid, seen)));
    }
    Estimate const slope = size_slope(sizes, of_size);
    ledger.compare({fmt::format("{:.3f}", of_sizes), "all"}, {"size_slope", "slope with $1/L$"},
                   {{}, slope, 1, 0, slope_margin});
    macros.define("Slope", with_error(slope));
    experiment.write(values, "_values");
    experiment.write(curve(), "_theory");
    return conclude(experiment, ledger, std::move(macros));
}

} // namespace clack::validation
