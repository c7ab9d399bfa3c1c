#pragma once
// Pressure of soft balls against their stiffness: state points, one measurement, and what it should
// give.

#include "observables/pressure.hpp"
#include "reference/equation_of_state.hpp"
#include "reference/finite_size.hpp"
#include "reference/lammps.hpp"
#include "reference/lammps_files.hpp"
#include "reference/soft_balls.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/mutants/engine_maker.hpp"
#include "validation/records/campaign.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace clack::validation::pressure_vs_lammps {

constexpr double steps_per_contact = 20; // from 8 on energy keeps
constexpr double equilibration = 30;     // collisions per ball

/// What all jobs run.
inline std::string deck() { return reference::lammps_deck("lammps_periodic.in"); }

/// A periodic fluid, and how hard its soft balls are.
struct StatePoint {
    double packing_fraction;
    std::int64_t count;
    double production; // collisions per ball that are averaged over, in one replicate
    int replicates;
    std::vector<double> stiffnesses;
    std::size_t first_judged; // softer balls overlap by too much for the first order

    double number_density() const { return packing_fraction * 6 / std::numbers::pi; }
    double theory() const { return reference::periodic_compressibility(number_density(), count); }
    /// Collisions per ball and time.
    double rate() const {
        double const freedom = 3 * static_cast<double>(count) - 3;
        return reference::collision_rate(
            reference::collisional_compressibility(number_density(), count), freedom);
    }
    System system(double const diameter) const {
        return {.boundary = Boundary::periodic,
                .side = std::cbrt(static_cast<double>(count) / number_density()),
                .count = count,
                .diameter = diameter};
    }
    std::string text() const {
        return fmt::format("packing_fraction={} count={} equilibration={} production={} "
                           "steps_per_contact={} stiffnesses={} deck={:016x}",
                           packing_fraction, count, equilibration, production, steps_per_contact,
                           fmt::join(stiffnesses, ","), hash_of(deck()));
    }
};

inline std::vector<StatePoint> state_points(Profile const profile) {
    bool const full = profile == Profile::full;
    std::vector<double> stiffnesses;
    for (double k = 1e3; k < (full ? 3e5 : 1e5); k *= 4) stiffnesses.push_back(k);
    return {{0.2, 256, full ? 1000.0 : 120.0, full ? 16 : 6, stiffnesses, 1},
            {0.4, 256, full ? 2000.0 : 200.0, full ? 16 : 6, stiffnesses, 1}};
}

/// LAMMPS is dear and its replicates few: with five degrees of freedom Student's t would miss what
/// must be caught if a false alarm were as rare as elsewhere.
constexpr Risks risks{.false_alarm = 0.01};

/// A difference that would not matter, as a part of Zc, the collisional part of Z: more than terms
/// of second order can be, a few times (1 - d_BH)^2, 4e-4 at the softest judged; half (in the full
/// profile a third) of what softness does where it does least, to the hardest balls in the dilute
/// fluid.
constexpr double margin(Profile const profile) { return profile == Profile::quick ? 0.015 : 5e-3; }

enum class Width {
    plain,  // diameter 1: shown, not judged, and a third as long
    widened // so much more that their Barker-Henderson diameter is 1 at kT = 1
};

inline double diameter_of(Width const width, double const stiffness) {
    constexpr double kt = 1;
    return width == Width::plain ? 1 : 2 - reference::barker_henderson_diameter(1, stiffness, kt);
}

inline Scene scene_of(StatePoint const& point, double const diameter, std::uint64_t const seed) {
    Scene scene;
    scene.system = point.system(diameter);
    scene.arrangement = Arrangement::random;
    scene.seed = seed;
    return scene;
}

/// What a job of lammps_periodic.in needs; its start is equilibrated with hard balls as wide.
inline reference::LammpsJob job(reference::LammpsFolder const& folder, StatePoint const& point,
                                std::string const& name, Width const width, double const stiffness,
                                std::uint64_t const seed) {
    Scene const scene = scene_of(point, diameter_of(width, stiffness), seed);
    auto const engine = make_true_engine(scene);
    engine->advance({.time = equilibration / point.rate()});
    Snapshot const shot = engine->snapshot();
    reference::write_lammps_data(folder / (name + ".data"), scene.system,
                                 {shot.positions, shot.velocities});
    double const dt = reference::contact_duration(stiffness) / steps_per_contact;
    // Half of the time that the hard balls took for the soft ones to forget them.
    auto const steps = [&](double const collisions_per_ball) {
        return std::llround(collisions_per_ball / point.rate() / dt);
    };
    return {{"data", name + ".data"},
            {"k", fmt::format("{:.17g}", stiffness)},
            {"dt", fmt::format("{:.17g}", dt)},
            {"before", fmt::format("{}", steps(equilibration / 2))},
            {"steps", fmt::format("{}", steps(point.production / (width == Width::plain ? 3 : 1)))},
            {"means", name + ".means"}};
}

/// The compressibility factor of the engine's hard balls, by the virial.
inline double hard_compressibility(StatePoint const& point, std::uint64_t const seed) {
    auto const engine = make_true_engine(scene_of(point, 1, seed));
    engine->advance({.time = equilibration / point.rate()});
    engine->start_clock();
    double const time = 20 * point.production / point.rate(); // it costs little
    engine->advance({.time = time});
    double const energy = engine->kinetic_energy();
    double const kt = temperature(engine->system(), energy, engine->momentum());
    return compressibility_factor(engine->system(), kt,
                                  {{0, {}, energy}, {time, engine->tallies(), energy}})
        .virial.value()
        .value;
}

/// Z of the engine's balls; then for each stiffness Z and kT of the soft balls, plain and widened.
inline Measurement measure(StatePoint const& point, std::uint64_t const seed) {
    reference::LammpsFolder const folder;
    std::vector<reference::LammpsJob> jobs;
    std::vector<std::string> names;
    for (double const stiffness : point.stiffnesses) {
        for (Width const width : {Width::plain, Width::widened}) {
            names.push_back(fmt::format("{}", names.size()));
            jobs.push_back(job(folder, point, names.back(), width, stiffness, seed));
        }
    }
    reference::run_lammps(folder, deck(), jobs);
    Measurement values{hard_compressibility(point, seed)};
    for (std::string const& name : names) {
        auto const means = reference::read_lammps_means(folder / (name + ".means"));
        double const pressure = means.at(0), kt = means.at(1);
        values.push_back(pressure / (point.number_density() * kt));
        values.push_back(kt);
    }
    return values;
}

/// Where in a Measurement the soft balls stand.
inline std::size_t place_of(std::size_t const stiffness, Width const width) {
    return 1 + 4 * stiffness + (width == Width::plain ? 0 : 2);
}

/// Z that theory gives hard balls of the Barker-Henderson diameter at this kT.
inline double softened_theory(StatePoint const& point, double const diameter,
                              double const stiffness, double const kt) {
    double const d = reference::barker_henderson_diameter(diameter, stiffness, kt);
    return reference::periodic_compressibility(point.number_density() * d * d * d, point.count);
}

/// Z of widened balls, brought to hard ones of diameter 1: the kinetic temperature falls a little
/// below 1 while balls overlap, and with it their Barker-Henderson diameter rises above 1, by which
/// theory changes Z by so much.
inline Estimate hardened(StatePoint const& point, std::vector<Measurement> const& replicates,
                         std::size_t const stiffness) {
    double const k = point.stiffnesses[stiffness];
    std::size_t const place = place_of(stiffness, Width::widened);
    return mean_of(replicates, [&](Measurement const& replicate) {
        return replicate[place] + point.theory() -
               softened_theory(point, diameter_of(Width::widened, k), k, replicate[place + 1]);
    });
}

/// The engine against theory; then for each stiffness the soft balls as they are, for which theory
/// gives no more than a guide, and widened: against theory and, where they are judged, the engine.
inline void enter(Ledger& ledger, StatePoint const& point,
                  std::vector<Measurement> const& replicates, double const relative_margin) {
    double const theory = point.theory(), part = relative_margin * (theory - 1);
    constexpr double of_theory = 2e-5; // relative, see reference/equation_of_state.hpp
    double const theory_error = of_theory * reference::modified_klm(point.packing_fraction);
    Estimate const hard = mean_of(replicates, std::size_t{0});
    std::string const eta = cell(point.packing_fraction);
    ledger.compare({eta, "hard"}, {"clack_theory", "$Z$, clack"},
                   {{}, hard, theory, theory_error, part});
    for (std::size_t k = 0; k < point.stiffnesses.size(); ++k) {
        std::vector<std::string> const state{eta, cell(point.stiffnesses[k])};
        std::size_t const plain = place_of(k, Width::plain);
        double const kt = mean_of(replicates, plain + 1).value;
        ledger.guide(
            state, {"plain_softened", "$Z$, plain; softened theory"},
            {{}, mean_of(replicates, plain), softened_theory(point, 1, point.stiffnesses[k], kt)});
        Comparison const soft{{}, hardened(point, replicates, k), theory, theory_error, part};
        Quantity const widened{"soft_theory", "$Z$, widened"};
        if (k < point.first_judged) {
            ledger.guide(state, widened, soft);
            continue;
        }
        ledger.compare(state, widened, soft);
        ledger.compare(state, {"soft_clack", "$Z$, widened; clack"},
                       {{}, soft.measured, hard.value, hard.error, part});
    }
}

} // namespace clack::validation::pressure_vs_lammps
