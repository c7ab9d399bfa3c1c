#include "scenes/insertion.hpp"
#include "scenes/lattice.hpp"
#include "scenes/limits.hpp"
#include "scenes/message.hpp"
#include "scenes/packing.hpp"
#include "scenes/place_check.hpp"
#include "scenes/scene.hpp"
#include "scenes/velocities.hpp"

#include <fmt/format.h>

#include <cmath>

namespace clack {

namespace {

InputError refuse(Scene const& scene, std::string const& message) {
    return input_error(scene.source.empty() ? message
                                            : fmt::format("{} ({})", message, scene.source));
}

/// The trajectory that the scene starts from, where it starts from one.
Start read_file(Scene const& scene, StartReader const& read_start) {
    if (scene.arrangement != Arrangement::file && scene.distribution != Distribution::file)
        return {};
    if (!read_start)
        throw refuse(scene, fmt::format("path = \"{}\": no trajectory can be read here; list the "
                                        "balls in the scene",
                                        scene.start_path));
    return read_start(scene.start_path);
}

void check_length(Scene const& scene, std::string const& what, Eigen::Matrix3Xd const& columns) {
    if (columns.cols() != scene.system.count)
        throw refuse(scene, fmt::format("{} of {} balls where count = {}: they must agree; change "
                                        "count",
                                        what, columns.cols(), scene.system.count));
}

Eigen::Matrix3Xd place_balls(Scene const& scene, Eigen::Matrix3Xd const& from_file) {
    switch (scene.arrangement) {
    case Arrangement::grid:
        return place_on_grid(scene.system);
    case Arrangement::fcc:
        return place_on_fcc(scene.system);
    case Arrangement::random:
        return place_at_random(scene.system, scene.seed);
    case Arrangement::explicit_:
        return scene.positions;
    case Arrangement::file:
        return from_file;
    }
    throw std::logic_error("no such arrangement");
}

Eigen::Matrix3Xd give_velocities(Scene const& scene, Eigen::Matrix3Xd const& from_file) {
    switch (scene.distribution) {
    case Distribution::maxwell:
        return draw_maxwell_velocities(scene.system, scene.temperature, scene.seed);
    case Distribution::equal_speed:
        return draw_equal_speeds(scene.system, scene.temperature, scene.seed);
    case Distribution::explicit_:
        return scene.velocities;
    case Distribution::file:
        return from_file;
    }
    throw std::logic_error("no such distribution");
}

void check_finite(Scene const& scene, Eigen::Matrix3Xd const& velocities) {
    for (Eigen::Index ball = 0; ball < velocities.cols(); ++ball)
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            if (!std::isfinite(velocities(axis, ball)))
                throw refuse(scene, fmt::format("velocity {} of ball {} = {}: must be a finite "
                                                "number; correct it",
                                                "xyz"[axis], ball, velocities(axis, ball)));
}

/// A goal that counts collisions needs balls that can meet.
void check_that_something_happens(Scene const& scene, double fastest) {
    std::string const goal = scene.equilibrate > 0       ? "equilibrate"
                             : scene.collisions_per_ball ? "collisions_per_ball"
                             : scene.collisions          ? "collisions"
                                                         : "";
    if (goal.empty()) return;
    if (scene.system.count == 1)
        throw refuse(scene, goal + " counts collisions between balls, and a single ball has none: "
                                   "nothing will ever happen; set time instead");
    if (fastest == 0)
        throw refuse(scene, goal + " counts collisions, and all velocities are zero: nothing will "
                                   "ever happen; give a temperature or velocities, or set time "
                                   "instead");
}

/// Speeds must suit the precision, the goal's time and the time between frames.
void check_speeds(Scene const& scene, double fastest) {
    if (fastest == 0) return;
    auto const [smallest, largest] = magnitudes(scene.precision);
    if (fastest < smallest || fastest > largest)
        throw refuse(scene, fmt::format("the fastest ball has speed {:.4g}: must lie in [{:.4g}, "
                                        "{:.4g}] at this precision; choose other units",
                                        fastest, smallest, largest));
    double const crossings = scene.time.value_or(0) * fastest / scene.system.side;
    if (crossings > most_crossings)
        throw refuse(scene,
                     fmt::format("time = {}: the fastest ball crosses the cube {:.4g} times, "
                                 "above {:.4g}; lower it",
                                 *scene.time, crossings, most_crossings));
    double const shortest = shortest_frame_interval * scene.system.diameter / fastest;
    if (scene.frame_interval > 0 && scene.frame_interval < shortest)
        throw refuse(scene, fmt::format("frame_interval = {}: must be 0 or at least {:.4g}, {:.0e} "
                                        "of the time in which the fastest ball moves its diameter; "
                                        "raise it",
                                        scene.frame_interval, shortest, shortest_frame_interval));
}

void check_motion(Scene const& scene, Eigen::Matrix3Xd const& velocities) {
    check_finite(scene, velocities);
    double const fastest = std::sqrt(velocities.colwise().squaredNorm().maxCoeff());
    check_that_something_happens(scene, fastest);
    check_speeds(scene, fastest);
}

} // namespace

Start make_start(Scene const& scene, StartReader const& read_start) {
    if (scene.system.count < 1) throw refuse(scene, "count = 0: must be at least 1; raise it");
    if (auto const reason = why_it_does_not_fit(scene.system, scene.arrangement, CubeGivenBy::side);
        !reason.empty())
        throw refuse(scene, fmt::format("side = {}: {}", scene.system.side, reason));

    Start const file = read_file(scene, read_start);
    Start start{place_balls(scene, file.positions), give_velocities(scene, file.velocities)};
    check_length(scene, "places", start.positions);
    check_length(scene, "velocities", start.velocities);
    check_motion(scene, start.velocities);

    if (auto const reason = why_places_are_wrong(scene.system, start.positions); !reason.empty())
        throw refuse(scene, reason);
    wrap_places(scene.system, start.positions);
    return start;
}

} // namespace clack
