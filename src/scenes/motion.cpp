#include "scenes/motion.hpp"

#include "scenes/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace clack {

namespace {

/// What the run counts in collisions between balls, if anything.
struct CountedGoal {
    Key key;
    double value;
};
std::optional<CountedGoal> counted_goal(Scene const& scene) {
    if (scene.equilibrate > 0) return CountedGoal{key::equilibrate, scene.equilibrate};
    if (scene.collisions_per_ball)
        return CountedGoal{key::collisions_per_ball, *scene.collisions_per_ball};
    if (scene.collisions)
        return CountedGoal{key::collisions, static_cast<double>(*scene.collisions)};
    return std::nullopt;
}

std::optional<Objection> objection_to_rest(Scene const& scene, double fastest) {
    auto const goal = counted_goal(scene);
    std::string const value = goal ? fmt::format("{}", goal->value) : "";
    if (goal && scene.system.count == 1) {
        return Objection{goal->key, value,
                         "is never reached, for a single ball has no other to collide with; set "
                         "time instead"};
    }
    if (goal && fastest == 0) {
        return Objection{goal->key, value,
                         "is never reached, for all velocities are zero: nothing will ever happen; "
                         "give the balls velocities, or set time instead"};
    }
    if (scene.time.value_or(0) > longest_rest && fastest == 0) {
        return Objection{key::time, fmt::format("{}", *scene.time),
                         fmt::format("is above {:.4g}, the longest that the clock of balls at rest "
                                     "runs; lower it, or give the balls velocities",
                                     longest_rest)};
    }
    return std::nullopt;
}

} // namespace

std::optional<Objection> objection_to_motion(Scene const& scene, double fastest) {
    if (auto objection = objection_to_rest(scene, fastest)) return objection;
    if (fastest == 0) return std::nullopt;

    auto const [smallest, largest] = magnitudes(scene.precision);
    if (fastest < smallest || fastest > largest) {
        return Objection{
            key::distribution, "...",
            fmt::format("the fastest ball has speed {:.4g}, which must lie in [{:.4g}, "
                        "{:.4g}] at this precision; choose other units",
                        fastest, smallest, largest)};
    }
    double const crossings = scene.time.value_or(0) * fastest / scene.system.side;
    if (crossings > most_crossings) {
        return Objection{
            key::time, fmt::format("{}", *scene.time),
            fmt::format("the fastest ball crosses the cube {:.4g} times, above {:.4g}; "
                        "lower it",
                        crossings, most_crossings)};
    }
    double const shortest = shortest_frame_interval * scene.system.diameter / fastest;
    if (scene.frame_interval > 0 && scene.frame_interval < shortest) {
        return Objection{
            key::frame_interval, fmt::format("{}", scene.frame_interval),
            fmt::format("must be 0 or at least {:.4g}, {:.0e} of the time in which the "
                        "fastest ball moves its diameter; raise it",
                        shortest, shortest_frame_interval)};
    }
    return std::nullopt;
}

std::optional<double> expected_speed(Scene const& scene) {
    switch (scene.distribution) {
    case Distribution::explicit_:
        return fastest_speed(scene.velocities);
    case Distribution::file:
        return std::nullopt;
    default:
        return std::sqrt(3 * scene.temperature / scene.system.mass);
    }
}

double fastest_speed(Eigen::Matrix3Xd const& velocities) {
    double fastest = 0;
    for (auto const& velocity : velocities.colwise())
        fastest = std::max(fastest, velocity.stableNorm());
    return fastest;
}

} // namespace clack
