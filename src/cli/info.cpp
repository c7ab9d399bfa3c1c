#include "cli/commands.hpp"
#include "cli/memory.hpp"
#include "cli/schedule.hpp"
#include "cli/summary.hpp"
#include "io/trajectory_reader.hpp"
#include "reference/horizon.hpp"
#include "simulation/model_choice.hpp"
#include "state/errors.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

namespace clack {

namespace {

void line(char const* name, std::string const& value) { fmt::print("{:<18}{}\n", name, value); }

void print_system(System const& system) {
    line("balls",
         fmt::format("{}, diameter {:g}, mass {:g}", system.count, system.diameter, system.mass));
    line("container",
         fmt::format("{}, side {:.10g}", system.boundary == Boundary::walls ? "walls" : "periodic",
                     system.side));
    line("packing fraction", fmt::format("{:.6g}", system.packing_fraction()));
    line("number density", fmt::format("{:.6g} / length^3", system.number_density()));
}

/// kT of a scene that draws its velocities, else of those it lists; none where they are in a file.
std::optional<double> scene_temperature(Scene const& scene) {
    if (scene.distribution == Distribution::file) return std::nullopt;
    if (scene.distribution != Distribution::explicit_) return scene.temperature;
    double energy = 0;
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
    for (Eigen::Index ball = 0; ball < scene.velocities.cols(); ++ball) {
        Eigen::Vector3d const velocity = scene.velocities.col(ball);
        energy += 0.5 * scene.system.mass * velocity.squaredNorm();
        momentum += scene.system.mass * velocity;
    }
    return temperature(scene.system, energy, momentum);
}

/// Collisions per second here and now: of a short run, where building one costs little.
std::optional<double> measured_speed(Scene const& scene) {
    constexpr std::int64_t count_max = 20'000; // a second at most
    constexpr double seconds = 0.3;
    if (scene.system.count > count_max) return std::nullopt;
    auto const engine =
        make_engine(scene.system, scene.method, scene.precision, make_start(scene, last_frame));
    using Clock = std::chrono::steady_clock;
    auto const begin = Clock::now();
    auto const elapsed = [&] {
        return std::chrono::duration<double>(Clock::now() - begin).count();
    };
    Goal goal;
    goal.events = 1000;
    while (elapsed() < seconds && engine->advance(goal) == Stop::events) {
    }
    return static_cast<double>(engine->tallies().ball_collisions) / elapsed();
}

void print_goal(Scene const& scene) {
    Schedule const schedule(scene);
    auto const kt = scene_temperature(scene);
    double const rate = kt ? reference::rough_collision_rate(scene.system, *kt) : 0;
    double const half = static_cast<double>(scene.system.count) / 2;
    double const collisions =
        scene.time ? rate * half * *scene.time : static_cast<double>(schedule.end_collisions());
    std::string const before =
        schedule.equilibration() > 0
            ? fmt::format(", after {} collisions of equilibration", schedule.equilibration())
            : "";
    if (scene.time) {
        line("goal",
             fmt::format("time {:g}, about {:.3g} collisions{}", *scene.time, collisions, before));
    } else {
        line("goal", fmt::format("{} collisions{}", schedule.end_collisions(), before));
    }
    if (rate > 0) {
        line("collision rate", fmt::format("about {:.3g} / (ball time): Enskog's theory", rate));
    }
    if (auto const horizon = reference::horizon(scene.system, scene.precision, rate))
        line("horizon", in_words(*horizon));
    if (auto const speed = measured_speed(scene); speed && *speed > 0) {
        double const all = static_cast<double>(schedule.equilibration()) + collisions;
        double const seconds = all / *speed;
        line("duration",
             fmt::format("{}{} at {:.2g} collisions/s, as measured just now",
                         seconds < 1 ? "" : "about ", duration_in_words(seconds), *speed));
    } else {
        line("duration", "not estimated");
    }
}

int scene_info(std::string const& path, std::vector<std::string> const& overrides) {
    auto const scene = read_scene(path, overrides);
    auto const choice = choose_model(scene.system, scene.method, scene.precision);
    auto const model = describe(choice, scene.system, scene.precision);
    line("scene", path + (scene.title.empty() ? "" : ": " + scene.title));
    print_system(scene.system);
    line("model", fmt::format("{}, {}, {} in {}: {}", model.boundary, model.search, model.queue,
                              model.precision, model.reason));
    line("memory", fmt::format("about {} of {} available",
                               bytes_in_words(static_cast<double>(run_bytes(scene))),
                               bytes_in_words(static_cast<double>(available_bytes()))));
    require_memory(scene);
    print_goal(scene);
    return exit_done;
}

char const* in_words(Phase phase) {
    switch (phase) {
    case Phase::equilibrating:
        return "equilibrating: resumable";
    case Phase::under_way:
        return "under way or stopped: resumable";
    default:
        return "finished: resumable with a larger goal";
    }
}

void print_rows(TrajectoryReader const& file) {
    auto const frames = file.frame_count();
    line("frames", frames == 0 ? "none yet"
                               : fmt::format("{} from t = {:.10g} to {:.10g}", frames,
                                             file.frame_time(0), file.frame_time(frames - 1)));
    line("samples", fmt::format("{}", file.sample_count()));
    line("events", file.header().events == Events::stored ? fmt::format("{}", file.event_count())
                                                          : "not stored");
}

/// As the file's head has it, but for the collision rate, which the run has meanwhile measured.
std::optional<Horizon> horizon_of(TrajectoryReader const& file) {
    auto horizon = file.header().horizon;
    auto const& point = file.resume_point();
    if (!horizon || point.phase == Phase::equilibrating || file.sample_count() < 2) return horizon;
    auto const samples = file.samples(file.sample_count());
    double const collisions = 2 * static_cast<double>(samples.back().tallies.ball_collisions) /
                              static_cast<double>(file.header().system.count);
    if (collisions >= 1)
        horizon->time = horizon->collisions_per_ball * samples.back().time / collisions;
    return horizon;
}

int trajectory_info(std::string const& path) {
    TrajectoryReader const file(path);
    auto const& header = file.header();
    line("trajectory", path);
    print_system(header.system);
    print_rows(file);
    auto const& point = file.resume_point();
    line("state", fmt::format("{}, at {} collisions", in_words(point.phase),
                              point.engine.tallies.ball_collisions));
    if (file.left_open()) line("", "its writer is at work, or was killed");
    line("scene", header.scene_source);
    line("seed", fmt::format("{}", header.seed));
    auto const& model = header.model;
    line("model", fmt::format("{}, {}, {} in {}", model.boundary, model.search, model.queue,
                              model.precision));
    if (auto const horizon = horizon_of(file)) line("horizon", in_words(*horizon));
    auto const& provenance = header.provenance;
    line("written by", fmt::format("clack {} ({})", provenance.version, provenance.commit));
    line("compiled with", fmt::format("{}: {}", provenance.compiler, provenance.flags));
    line("on", provenance.machine);
    return exit_done;
}

} // namespace

int info_command(std::string const& path, std::vector<std::string> const& overrides) {
    if (!is_hdf5(path)) return scene_info(path, overrides);
    if (!overrides.empty()) {
        throw InputError("--set " + overrides.front() + ": " + path +
                         " is a trajectory, and only a scene can be set");
    }
    return trajectory_info(path);
}

} // namespace clack
