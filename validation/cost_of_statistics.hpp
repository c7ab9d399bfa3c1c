#pragma once
// What a digit of the compressibility factor costs: state point, methods, and one measurement.

#include "observables/pressure.hpp"
#include "reference/frame_stepping.hpp"
#include "validation/pressure_vs_lammps.hpp"
#include "validation/stepped_runs.hpp"
#include "validation/timing.hpp"

namespace clack::validation::cost_of_statistics {

constexpr double slope_margin = 0.15, bias_margin = 3e-3;

/// One fluid, by every method with its knob.
struct Plan {
    pressure_vs_lammps::StatePoint point; // with its theory
    int engine_replicates, stepped_replicates;
    std::vector<double> durations; // collisions per ball, each four times the one before
    std::size_t stepped_durations; // steps are followed for so many of these
    std::vector<double> steps;     // of frames  [mean free times]
    std::vector<double> stiffnesses;
};

inline Plan plan(Profile const profile) {
    bool const full = profile == Profile::full;
    Plan plan{{0.2, 108, 0, 0, {}, 0}, full ? 100 : 96,  full ? 30 : 6, {},
              full ? 4u : 3u,          {0.3, 0.1, 0.03}, {1e3, 1.6e4}};
    for (double duration = 12.5; duration < (full ? 20'000 : 5'000); duration *= 4)
        plan.durations.push_back(duration);
    if (full) {
        plan.steps.push_back(0.01);
        plan.stiffnesses.push_back(2.56e5);
    }
    return plan;
}

/// Z by the virial of what has been counted in so much time at kT = 1.
inline double compressibility(System const& system, Tallies const& tallies, double const time) {
    auto const n = static_cast<double>(system.count);
    return 1 - 1 / n + tallies.virial / (3 * n * time);
}

/// Balls in equilibrium at kT = 1.
inline Start start_of(Plan const& plan, std::uint64_t const seed) {
    constexpr double equilibration = 30; // collisions per ball
    return equilibrated(plan.point.system(1), equilibration, seed);
}

/// Processor time and Z for each duration, one after the other; each begins where all begin.
inline Measurement measure_engine(Plan const& plan, std::uint64_t const seed) {
    System const system = plan.point.system(1);
    auto const engine = make_true_method(system, Method::fast, start_of(plan, seed));
    Measurement values;
    double const begin = processor_seconds();
    for (double const duration : plan.durations) {
        double const time = duration / plan.point.rate();
        engine->advance({.time = time});
        values.push_back(processor_seconds() - begin);
        values.push_back(compressibility(system, engine->tallies(), time));
    }
    return values;
}

/// The same by frames.
///   step   [mean free times]
inline Measurement measure_frames(Plan const& plan, double const step, std::uint64_t const seed) {
    System const system = plan.point.system(1);
    reference::FrameStepping frames(system, start_of(plan, seed), step / plan.point.rate());
    Measurement values;
    double const begin = processor_seconds();
    std::int64_t done = 0;
    for (std::size_t k = 0; k < plan.stepped_durations; ++k) {
        std::int64_t const steps = std::llround(plan.durations[k] / step);
        frames.advance(steps - done);
        done = steps;
        values.push_back(processor_seconds() - begin);
        values.push_back(compressibility(system, frames.tallies(), frames.time()));
    }
    return values;
}

/// The same by soft balls, a job for each duration.
inline Measurement measure_lammps(Plan const& plan, double const stiffness, std::string const& deck,
                                  std::uint64_t const seed) {
    constexpr double before = 5; // collisions per ball, for contacts to come about
    reference::LammpsFolder const folder;
    reference::write_lammps_data(folder / "start.data", plan.point.system(1), start_of(plan, seed));
    double const dt =
        reference::contact_duration(stiffness) / pressure_vs_lammps::steps_per_contact;
    auto const steps = [&](double const duration) {
        return fmt::format("{}", std::llround(duration / plan.point.rate() / dt));
    };
    std::vector<reference::LammpsJob> jobs;
    for (std::size_t k = 0; k < plan.stepped_durations; ++k)
        jobs.push_back({{"data", "start.data"},
                        {"k", fmt::format("{:.17g}", stiffness)},
                        {"dt", fmt::format("{:.17g}", dt)},
                        {"before", steps(before)},
                        {"steps", steps(plan.durations[k])},
                        {"means", fmt::format("{}.means", k)}});
    reference::run_lammps(folder, deck, jobs);
    auto const seconds = work_precision::loop_seconds(folder); // before and after, job by job
    Measurement values;
    for (std::size_t k = 0; k < plan.stepped_durations; ++k) {
        auto const means = reference::read_lammps_means(folder / fmt::format("{}.means", k));
        values.push_back(seconds.at(2 * k + 1));
        values.push_back(means.at(0) / (plan.point.number_density() * means.at(1)));
    }
    return values;
}

} // namespace clack::validation::cost_of_statistics
