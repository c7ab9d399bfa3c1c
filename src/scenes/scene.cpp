#include "scenes/scene.hpp"

#include "scenes/document.hpp"
#include "scenes/limits.hpp"
#include "scenes/message.hpp"
#include "scenes/motion.hpp"
#include "scenes/packing.hpp"
#include "scenes/place_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <limits>

namespace clack {

namespace {

constexpr double lowest = std::numeric_limits<double>::lowest();

/// A value that the scene cannot do without.
template <class Value>
Value required(Document const& document, Key key, std::optional<Value> value,
               std::string const& advice) {
    if (!value) throw document.missing(key, advice);
    return std::move(*value);
}

/// A key that only one choice makes use of.
void refuse_unless(bool used, Document const& document, Key key, std::string const& rule) {
    if (!used && document.has(key)) throw document.mistake(key, rule);
}

void read_model(Document const& document, Scene& scene) {
    scene.method = document
                       .choice<Method>(key::method, {{"auto", Method::automatic},
                                                     {"table", Method::table},
                                                     {"heap", Method::heap},
                                                     {"fast", Method::fast}})
                       .value_or(Method::automatic);
    scene.precision = document
                          .choice<Precision>(key::precision, {{"float", Precision::single_},
                                                              {"double", Precision::double_},
                                                              {"long double", Precision::extended},
                                                              {"quad", Precision::quadruple}})
                          .value_or(Precision::double_);
}

void read_balls(Document const& document, Scene& scene) {
    auto const [smallest, largest] = magnitudes(scene.precision);
    System& system = scene.system;
    scene.arrangement = required(
        document, key::arrangement,
        document.choice<Arrangement>(key::arrangement, {{"grid", Arrangement::grid},
                                                        {"fcc", Arrangement::fcc},
                                                        {"random", Arrangement::random},
                                                        {"explicit", Arrangement::explicit_},
                                                        {"file", Arrangement::file}}),
        "say how the balls are placed: grid, fcc, random, explicit or file");
    system.count =
        required(document, key::count, document.whole_number(key::count, 1, largest_count_of_balls),
                 "say how many balls there are");
    system.diameter = document.number(key::diameter, {smallest, largest, "a length"}).value_or(1);
    system.mass = document.number(key::mass, {smallest, largest, "a mass"}).value_or(1);

    bool const listed = scene.arrangement == Arrangement::explicit_;
    refuse_unless(listed, document, key::positions,
                  "goes with arrangement = \"explicit\" only; remove it or change arrangement");
    if (!listed) return;
    scene.positions = required(document, key::positions,
                               document.vectors(key::positions, furthest_image * largest),
                               "arrangement = \"explicit\" needs [x, y, z] for each ball");
    if (scene.positions.cols() != system.count) {
        throw document.mistake(key::positions,
                               fmt::format("must list count = {} balls, and lists {}; make them "
                                           "agree",
                                           system.count, scene.positions.cols()));
    }
}

/// Side of the cube; the balls are known.
void read_container(Document const& document, Scene& scene) {
    auto const [smallest, largest] = magnitudes(scene.precision);
    System& system = scene.system;
    system.boundary =
        required(document, key::boundary,
                 document.choice<Boundary>(
                     key::boundary, {{"walls", Boundary::walls}, {"periodic", Boundary::periodic}}),
                 "say what bounds the cube: walls or periodic");
    auto const side = document.number(key::side, {smallest, largest, "a length"});
    auto const packing =
        document.number(key::packing_fraction, {lowest, -lowest, "a share of the cube"});
    if (side && packing) {
        throw document.mistake(key::packing_fraction,
                               "excludes side, which is given too; keep one of them");
    }
    if (!side && !packing)
        throw document.missing(key::side, "give exactly one of side and packing_fraction");
    if (packing && !(*packing > 0 && *packing < close_packing)) {
        throw document.mistake(key::packing_fraction,
                               fmt::format("must lie in (0, {:.4f}), close packing; {} it",
                                           close_packing, *packing > 0 ? "lower" : "raise"));
    }
    system.side = side ? *side : side_of_packing_fraction(system.count, system.diameter, *packing);

    Key const given = side ? key::side : key::packing_fraction;
    double const ratio = largest_side_in_diameters(scene.precision);
    if (!(system.side <= ratio * system.diameter)) {
        throw document.mistake(
            given,
            fmt::format("the side is {:.4g} diameters, and this precision tells places apart "
                        "up to {:.4g}; {}",
                        system.side / system.diameter, ratio,
                        scene.precision == Precision::single_
                            ? "use more balls or precision = \"double\""
                            : "make the cube smaller"));
    }
    auto const reason = why_it_does_not_fit(
        system, scene.arrangement, side ? CubeGivenBy::side : CubeGivenBy::packing_fraction);
    if (!reason.empty()) throw document.mistake(given, reason);
}

void read_velocities(Document const& document, Scene& scene) {
    auto const [smallest, largest] = magnitudes(scene.precision);
    scene.distribution =
        required(document, key::distribution,
                 document.choice<Distribution>(key::distribution,
                                               {{"maxwell", Distribution::maxwell},
                                                {"equal_speed", Distribution::equal_speed},
                                                {"explicit", Distribution::explicit_},
                                                {"file", Distribution::file}}),
                 "say how the velocities are drawn: maxwell, equal_speed, explicit or file");
    scene.temperature =
        document.number(key::temperature, {0, largest, "an energy, kT"}).value_or(1);
    if (scene.temperature > 0 && scene.temperature < smallest) {
        throw document.mistake(
            key::temperature,
            fmt::format("must be 0 or lie in [{:.4g}, {:.4g}], an energy, kT", smallest, largest));
    }

    bool const listed = scene.distribution == Distribution::explicit_;
    refuse_unless(listed, document, key::velocities,
                  "goes with distribution = \"explicit\" only; remove it or change distribution");
    if (!listed) return;
    scene.velocities =
        required(document, key::velocities, document.vectors(key::velocities, largest),
                 "distribution = \"explicit\" needs [x, y, z] for each ball");
    if (scene.velocities.cols() != scene.system.count) {
        throw document.mistake(key::velocities,
                               fmt::format("must list count = {} balls, and lists {}; make them "
                                           "agree",
                                           scene.system.count, scene.velocities.cols()));
    }
}

/// The trajectory that places or velocities come from; a relative path starts at the scene's
/// folder.
void read_start_path(Document const& document, Scene& scene) {
    bool const places = scene.arrangement == Arrangement::file;
    bool const velocities = scene.distribution == Distribution::file;
    refuse_unless(places, document, key::start_path,
                  "goes with arrangement = \"file\" only; remove it or change arrangement");
    refuse_unless(velocities && !places, document, key::velocity_path,
                  "goes with distribution = \"file\" only, and not beside a path of [balls]; "
                  "remove it");
    if (!places && !velocities) return;
    Key const named_by = places ? key::start_path : key::velocity_path;
    std::filesystem::path const path = required(document, named_by, document.string(named_by),
                                                "name the trajectory to start from");
    if (path.empty()) throw document.mistake(named_by, "must name the trajectory to start from");
    scene.start_path = (std::filesystem::path(scene.source).parent_path() / path).string();
}

void read_goal(Document const& document, Scene& scene) {
    double const count = static_cast<double>(scene.system.count);
    Range const per_ball{0, 2 * most_collisions / count, "collisions per ball"};
    scene.equilibrate = document.number(key::equilibrate, per_ball).value_or(0);
    scene.collisions_per_ball = document.number(key::collisions_per_ball, per_ball);
    if (scene.collisions_per_ball == 0.0) {
        throw document.mistake(key::collisions_per_ball,
                               "must be above 0, or there is nothing to run");
    }
    scene.time = document.number(key::time, {0, magnitudes(Precision::double_).largest, "a time"});
    auto const collisions =
        document.whole_number(key::collisions, 1, static_cast<std::int64_t>(most_collisions));
    if (collisions) scene.collisions = static_cast<std::uint64_t>(*collisions);

    int const goals = scene.collisions_per_ball.has_value() + scene.time.has_value() +
                      scene.collisions.has_value();
    if (goals == 1) return;
    std::string const rule = "give exactly one of collisions_per_ball, time and collisions";
    if (goals == 0) throw document.missing(key::collisions_per_ball, rule);
    throw document.mistake(scene.collisions ? key::collisions : key::time,
                           "is one goal too many; " + rule);
}

void read_output(Document const& document, Scene& scene) {
    scene.frame_interval =
        document.number(key::frame_interval, {0, magnitudes(Precision::double_).largest, "a time"})
            .value_or(0);
    if (scene.time && scene.frame_interval > 0 &&
        *scene.time / scene.frame_interval > most_frames) {
        throw document.mistake(key::frame_interval,
                               fmt::format("makes {:.4g} frames of time = {}, above {:.4g}; raise "
                                           "it",
                                           *scene.time / scene.frame_interval, *scene.time,
                                           most_frames));
    }
    scene.events = document.flag(key::events).value_or(false) ? Events::stored : Events::dropped;
}

/// The rules that need places and speeds, where the scene itself has them: it can show the line.
void check_start(Document const& document, Scene const& scene) {
    if (scene.arrangement == Arrangement::explicit_) {
        if (auto const misplaced = misplaced_ball(scene.system, scene.positions)) {
            throw document.mistake_in_list(
                key::positions, static_cast<std::size_t>(misplaced->ball), misplaced->what);
        }
    }
    auto const fastest = expected_speed(scene);
    if (!fastest) return;
    if (auto const wrong = objection_to_motion(scene, *fastest))
        throw document.mistake(wrong->key, wrong->rule);
}

} // namespace

std::uint64_t collisions_of(double per_ball, std::int64_t count) {
    return static_cast<std::uint64_t>(std::ceil(per_ball * static_cast<double>(count) / 2));
}

Scene parse_scene(std::string const& text, std::string const& source,
                  std::vector<std::string> const& overrides) {
    Document const document(text, source, overrides);
    Scene scene;
    scene.source = source;
    scene.text = document.text();
    scene.title = document.string(key::title).value_or("");
    scene.seed = static_cast<std::uint64_t>(
        document.whole_number(key::seed, 0, std::numeric_limits<std::int64_t>::max()).value_or(0));
    read_model(document, scene); // first: how large numbers may be depends on the precision
    read_balls(document, scene);
    read_container(document, scene);
    read_velocities(document, scene);
    read_start_path(document, scene);
    read_goal(document, scene);
    read_output(document, scene);
    check_start(document, scene);
    return scene;
}

} // namespace clack
