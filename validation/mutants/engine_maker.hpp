#pragma once
// Whom an experiment puts to the test.

#include "scenes/scene.hpp"
#include "simulation/engine.hpp"
#include "validation/records/campaign.hpp"

#include <functional>
#include <memory>

namespace clack::validation {

/// Starts a scene: with the project's engine, or with a mutant of it that must not pass.
using EngineMaker = std::function<std::unique_ptr<Engine>(Scene const&)>;

inline std::unique_ptr<Engine> make_true_engine(Scene const& scene) {
    return make_engine(scene.system, scene.method, scene.precision, make_start(scene));
}

/// The tasks of an experiment that measures with the project's engine.
template <class StatePoint>
std::vector<Task> tasks_of(std::vector<StatePoint> const& points,
                           Measurement (*measure)(StatePoint const&, std::uint64_t,
                                                  EngineMaker const&)) {
    return tasks_of(points, [=](StatePoint const& point, std::uint64_t const seed) {
        return measure(point, seed, make_true_engine);
    });
}

/// Starts a method on balls in motion.
using MethodMaker =
    std::function<std::unique_ptr<Engine>(System const&, Method, Start const& start)>;

inline std::unique_ptr<Engine> make_true_method(System const& system, Method const method,
                                                Start const& start) {
    return make_engine(system, method, Precision::double_, start);
}

} // namespace clack::validation
