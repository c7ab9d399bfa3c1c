#pragma once
// What a finished run says about itself, for people and as JSON.

#include "observables/horizon.hpp"
#include "observables/pressure.hpp"
#include "scenes/scene.hpp"
#include "simulation/engine.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace clack {

/// Units are the scene's.
struct Summary {
    double time = 0; // since time 0
    std::uint64_t ball_collisions = 0, wall_collisions = 0;
    double cpu_seconds = 0; // of the event loop after equilibration
    double collisions_per_cpu_second = 0;
    double bytes_per_ball = 0;
    std::string method, precision, search, queue;
    CompressibilityFactor compressibility_factor;
    std::optional<Estimate> wall_pressure;
    double temperature = 0;
    double energy_drift = 0;    // relative to the energy at time 0
    double deepest_overlap = 0; // [diameters]
    std::optional<Horizon> horizon;
    std::uint64_t hash = 0; // of the collision sequence since time 0
    std::uint64_t seed = 0;
};

/// From an engine at the end of its run, and the samples since time 0.
Summary summarize(Scene const& scene, Engine const& engine, std::vector<Sample> const& samples,
                  double cpu_seconds);

/// Until when positions hold; the time by the run's own collision rate once each ball has had a
/// collision, by theory before.
///   kt          [energy]
///   collisions  between balls since time 0, in so much time
std::optional<Horizon> horizon_of(System const& system, Precision precision, double kt,
                                  std::uint64_t collisions, double time);

/// In a sentence.
std::string in_words(Horizon const& horizon);

enum class ShowHash { no, yes };

std::string as_text(Summary const& summary, ShowHash hash);
/// One object; what a run cannot give is null.
std::string as_json(Summary const& summary);

} // namespace clack
