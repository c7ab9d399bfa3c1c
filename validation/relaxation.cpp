// Does Boltzmann's H fall from starts far from equilibrium, and as fast as in a dilute gas?

#include "validation/relaxation.hpp"

#include "validation/harness/experiment.hpp"

namespace clack::validation {

using namespace relaxation;

Question const question{
    "relaxation",
    "From equal speeds, from one moving ball and from two temperatures in two halves: does "
    "Boltzmann's H fall, never rise, and fall as fast as Kac's walk, the law of the dilute gas?",
    percent(excess_margin) + " of what H has to lose from the first look on; " +
        percent(collisions_margin) + " of the collisions",
    "a relaxation a tenth too fast or too slow would not pass", Processes::one_a_state_point};

namespace {

void add_course(Csv& csv, StatePoint const& point, std::vector<Measurement> const& gas,
                std::vector<Measurement> const& walks) {
    for (std::size_t look = 0; look < looks().size(); ++look) {
        Estimate const h = mean_of(gas, 2 * look + 1), walked = mean_of(walks, 2 * look + 1);
        Estimate const met = mean_of(gas, 2 * look), expected = mean_of(walks, 2 * look);
        csv.row({name_of(point.begin), cell(looks()[look]), cell(h.value), cell(h.error),
                 cell(walked.value), cell(walked.error), cell(met.value), cell(met.error),
                 cell(expected.value), cell(expected.error)});
    }
}

} // namespace

Verdict ask(Experiment& experiment) {
    Ledger ledger({{"start", "start"}, {"time_per_mean_free_time", "$t\\nu$"}});
    Csv course({"start", "time_per_mean_free_time", "excess_H", "excess_H_error", "excess_H_walk",
                "excess_H_walk_error", "collisions_per_ball", "collisions_per_ball_error",
                "collisions_per_ball_walk", "collisions_per_ball_walk_error"});
    Macros macros("Relaxation");
    auto const points = state_points(experiment.profile());
    auto tasks = tasks_of(points, measure);
    for (StatePoint const& point : points)
        tasks.push_back({point.text() + " walk", point.walks,
                         [=](std::uint64_t const seed) { return walk(point, seed); }});
    auto const all = experiment.campaign().replicates(tasks);
    for (std::size_t k = 0; k < points.size(); ++k) {
        StatePoint const& point = points[k];
        auto const &gas = all[k], &walks = all[points.size() + k];
        enter(ledger, point, gas, walks);
        add_course(course, point, gas, walks);
        if (point.begin == Begin::equal_speeds) macros.define("Starts", cell(point.replicates));
    }
    experiment.write(course, "_course");
    macros.define("Balls", cell(ball_count));
    macros.define("Bins", cell(bin_count));
    return conclude(experiment, ledger, std::move(macros));
}

} // namespace clack::validation
