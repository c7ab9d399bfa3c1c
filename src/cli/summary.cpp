#include "cli/summary.hpp"

#include "io/provenance.hpp"
#include "reference/horizon.hpp"
#include "simulation/model_choice.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace clack {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(std::optional<Estimate> const& estimate) {
    if (!estimate || !std::isfinite(estimate->value)) return nullptr;
    Json const error = estimate->error ? Json(*estimate->error) : Json(nullptr);
    return {{"value", estimate->value}, {"error", error}};
}

std::string text_of(std::optional<Estimate> const& estimate) {
    if (!estimate) return "none";
    if (!estimate->error)
        return fmt::format("{:.6g} (too short a run for an error)", estimate->value);
    return fmt::format("{:.6g} +- {:.2g}", estimate->value, *estimate->error);
}

Json json_of(std::optional<Horizon> const& horizon) {
    if (!horizon) return nullptr;
    return {{"error", horizon->error},
            {"collisions_per_ball", horizon->collisions_per_ball},
            {"time", horizon->time}};
}

std::string hexadecimal(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

} // namespace

std::optional<Horizon> horizon_of(System const& system, Precision const precision, double const kt,
                                  std::uint64_t const collisions, double const time) {
    double const per_ball = 2 * static_cast<double>(collisions) / static_cast<double>(system.count);
    bool const is_measured = per_ball >= 1 && time > 0;
    return reference::horizon(system, precision,
                              is_measured ? per_ball / time
                                          : reference::rough_collision_rate(system, kt));
}

std::string in_words(Horizon const& horizon) {
    return fmt::format("positions to {:g} diameters until t = {:.3g}, {:.3g} collisions a ball; "
                       "beyond, statistics only",
                       horizon.error, horizon.time, horizon.collisions_per_ball);
}

Summary summarize(Scene const& scene, Engine const& engine, std::vector<Sample> const& samples,
                  double cpu_seconds) {
    auto const& tallies = engine.tallies();
    auto const& system = engine.system();
    Summary summary;
    summary.time = engine.time();
    summary.ball_collisions = tallies.ball_collisions;
    summary.wall_collisions = tallies.wall_collisions;
    summary.cpu_seconds = cpu_seconds;
    if (cpu_seconds > 0) {
        summary.collisions_per_cpu_second =
            static_cast<double>(tallies.ball_collisions) / cpu_seconds;
    }
    summary.bytes_per_ball =
        static_cast<double>(engine.bytes()) / static_cast<double>(system.count);
    summary.method = name_of(scene.method);
    auto const model = engine.model();
    summary.precision = model.precision;
    summary.search = model.search;
    summary.queue = model.queue;
    summary.temperature = temperature(system, engine.kinetic_energy(), engine.momentum());
    summary.compressibility_factor = compressibility_factor(system, summary.temperature, samples);
    summary.wall_pressure = wall_pressure(system, samples);
    if (!samples.empty() && samples.front().kinetic_energy > 0) {
        summary.energy_drift = engine.kinetic_energy() / samples.front().kinetic_energy - 1;
    }
    summary.deepest_overlap = tallies.deepest_overlap;
    summary.horizon = horizon_of(system, scene.precision, summary.temperature,
                                 tallies.ball_collisions, summary.time);
    summary.hash = engine.hash();
    summary.seed = scene.seed;
    return summary;
}

std::string as_text(Summary const& summary, ShowHash hash) {
    std::string text;
    auto const line = [&](char const* name, std::string const& value) {
        text += fmt::format("{:<22}{}\n", name, value);
    };
    line("time", fmt::format("{:.10g}", summary.time));
    line("collisions", fmt::format("{} between balls, {} with walls", summary.ball_collisions,
                                   summary.wall_collisions));
    line("speed", fmt::format("{:.3g} collisions per CPU second ({:.3g} s)",
                              summary.collisions_per_cpu_second, summary.cpu_seconds));
    line("model", fmt::format("{}, {}, {}, {:.0f} bytes a ball", summary.search, summary.queue,
                              summary.precision, summary.bytes_per_ball));
    line("temperature", fmt::format("{:.10g}", summary.temperature));
    line("Z by the virial", text_of(summary.compressibility_factor.virial));
    if (summary.wall_pressure) {
        line("Z by the walls", text_of(summary.compressibility_factor.wall));
        line("pressure on the walls", text_of(summary.wall_pressure));
    }
    line("energy drift", fmt::format("{:.2g}", summary.energy_drift));
    line("deepest overlap", fmt::format("{:.2g} diameters", summary.deepest_overlap));
    line("horizon", summary.horizon ? in_words(*summary.horizon) : "not known for so few balls");
    if (hash == ShowHash::yes) line("hash", hexadecimal(summary.hash));
    return text;
}

std::string as_json(Summary const& summary) {
    Json factor{{"virial", json_of(summary.compressibility_factor.virial)}};
    if (summary.wall_pressure) {
        factor["wall"] = json_of(summary.compressibility_factor.wall);
    }
    Json json{{"time", summary.time},
              {"ball_collisions", summary.ball_collisions},
              {"wall_collisions", summary.wall_collisions},
              {"cpu_seconds", summary.cpu_seconds},
              {"collisions_per_cpu_second", summary.collisions_per_cpu_second},
              {"bytes_per_ball", summary.bytes_per_ball},
              {"method", summary.method},
              {"search", summary.search},
              {"queue", summary.queue},
              {"precision", summary.precision},
              {"compressibility_factor", factor},
              {"wall_pressure", json_of(summary.wall_pressure)},
              {"temperature", summary.temperature},
              {"energy_drift", summary.energy_drift},
              {"deepest_overlap", summary.deepest_overlap},
              {"horizon", json_of(summary.horizon)},
              {"hash", hexadecimal(summary.hash)},
              {"seed", summary.seed},
              {"version", own_provenance().version}};
    return json.dump(2) + "\n";
}

} // namespace clack
