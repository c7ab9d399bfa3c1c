#include "scenes/insertion.hpp"
#include "scenes/lattice.hpp"
#include "scenes/message.hpp"
#include "scenes/motion.hpp"
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
    if (!read_start) {
        throw refuse(scene, fmt::format("path = \"{}\": no trajectory can be read here; list the "
                                        "balls in the scene",
                                        scene.start_path));
    }
    return read_start(scene.start_path);
}

void check_length(Scene const& scene, std::string const& what, Eigen::Matrix3Xd const& columns) {
    if (columns.cols() != scene.system.count) {
        throw refuse(scene, fmt::format("{} of {} balls where count = {}: they must agree; change "
                                        "count",
                                        what, columns.cols(), scene.system.count));
    }
}

Eigen::Matrix3Xd place_at_random(Scene const& scene) {
    try {
        return place_at_random(scene.system, scene.seed);
    } catch (LawBroken const& jam) {
        throw refuse(scene, fmt::format("arrangement = \"random\": {}, short of {:.4g}; lower it, "
                                        "take another seed, or arrangement = \"fcc\"",
                                        jam.what(), scene.system.packing_fraction()));
    }
}

Eigen::Matrix3Xd place_balls(Scene const& scene, Eigen::Matrix3Xd const& from_file) {
    switch (scene.arrangement) {
    case Arrangement::grid:
        return place_on_grid(scene.system);
    case Arrangement::fcc:
        return place_on_fcc(scene.system);
    case Arrangement::random:
        return place_at_random(scene);
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
    for (Eigen::Index ball = 0; ball < velocities.cols(); ++ball) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            if (!std::isfinite(velocities(axis, ball))) {
                throw refuse(scene, fmt::format("ball {} has v{} = {}: must be a finite "
                                                "number; correct it",
                                                ball, "xyz"[axis], velocities(axis, ball)));
            }
        }
    }
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
    check_finite(scene, start.velocities);
    if (auto const wrong = objection_to_motion(scene, fastest_speed(start.velocities)))
        throw refuse(scene, fmt::format("{} = {}: {}", wrong->key.name, wrong->value, wrong->rule));
    bool const drawn_up_by_hand =
        scene.arrangement == Arrangement::explicit_ || scene.arrangement == Arrangement::file;
    if (!drawn_up_by_hand) return start;
    if (auto const misplaced = misplaced_ball(scene.system, start.positions))
        throw refuse(scene, misplaced->what);
    wrap_places(scene.system, start.positions);
    return start;
}

} // namespace clack
