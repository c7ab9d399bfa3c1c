#include "scenes/scene.hpp"

#include "scenes/document.hpp"
#include "scenes/limits.hpp"
#include "scenes/message.hpp"
#include "scenes/packing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace clack {

namespace {

constexpr Key boundary_key{"container", "boundary"}, side_key{"container", "side"},
    packing_key{"container", "packing_fraction"}, count_key{"balls", "count"},
    arrangement_key{"balls", "arrangement"}, positions_key{"balls", "positions"},
    start_path_key{"balls", "path"}, distribution_key{"velocities", "distribution"},
    velocities_key{"velocities", "velocities"}, velocity_path_key{"velocities", "path"},
    per_ball_key{"run", "collisions_per_ball"}, time_key{"run", "time"},
    collisions_key{"run", "collisions"}, frames_key{"output", "frame_interval"};

constexpr double lowest = std::numeric_limits<double>::lowest();
constexpr std::uintmax_t largest_scene_file = std::uintmax_t{64} << 20; // larger ones are data

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
                       .choice<Method>({"run", "method"}, {{"auto", Method::automatic},
                                                           {"table", Method::table},
                                                           {"heap", Method::heap},
                                                           {"fast", Method::fast}})
                       .value_or(Method::automatic);
    scene.precision =
        document
            .choice<Precision>({"run", "precision"}, {{"float", Precision::single_},
                                                      {"double", Precision::double_},
                                                      {"long double", Precision::extended},
                                                      {"quad", Precision::quadruple}})
            .value_or(Precision::double_);
}

void read_balls(Document const& document, Scene& scene) {
    auto const [smallest, largest] = magnitudes(scene.precision);
    System& system = scene.system;
    scene.arrangement = required(
        document, arrangement_key,
        document.choice<Arrangement>(arrangement_key, {{"grid", Arrangement::grid},
                                                       {"fcc", Arrangement::fcc},
                                                       {"random", Arrangement::random},
                                                       {"explicit", Arrangement::explicit_},
                                                       {"file", Arrangement::file}}),
        "say how the balls are placed: grid, fcc, random, explicit or file");
    system.count =
        required(document, count_key, document.whole_number(count_key, 1, largest_count_of_balls),
                 "say how many balls there are");
    system.diameter =
        document.number({"balls", "diameter"}, {smallest, largest, "a length"}).value_or(1);
    system.mass = document.number({"balls", "mass"}, {smallest, largest, "a mass"}).value_or(1);

    bool const listed = scene.arrangement == Arrangement::explicit_;
    refuse_unless(listed, document, positions_key,
                  "goes with arrangement = \"explicit\" only; remove it or change arrangement");
    if (!listed) return;
    scene.positions =
        required(document, positions_key, document.vectors(positions_key, furthest_image * largest),
                 "arrangement = \"explicit\" needs [x, y, z] for each ball");
    if (scene.positions.cols() != system.count)
        throw document.mistake(positions_key,
                               fmt::format("must list count = {} balls, and lists {}; make them "
                                           "agree",
                                           system.count, scene.positions.cols()));
}

/// Side of the cube; the balls are known.
void read_container(Document const& document, Scene& scene) {
    auto const [smallest, largest] = magnitudes(scene.precision);
    System& system = scene.system;
    system.boundary =
        required(document, boundary_key,
                 document.choice<Boundary>(
                     boundary_key, {{"walls", Boundary::walls}, {"periodic", Boundary::periodic}}),
                 "say what bounds the cube: walls or periodic");
    auto const side = document.number(side_key, {smallest, largest, "a length"});
    auto const packing = document.number(packing_key, {lowest, -lowest, "a share of the cube"});
    if (side && packing)
        throw document.mistake(packing_key, "excludes side, which is given too; keep one of them");
    if (!side && !packing)
        throw document.missing(side_key, "give exactly one of side and packing_fraction");
    if (packing && !(*packing > 0 && *packing < close_packing))
        throw document.mistake(packing_key,
                               fmt::format("must lie in (0, {:.4f}), close packing; {} it",
                                           close_packing, *packing > 0 ? "lower" : "raise"));
    system.side = side ? *side : side_of_packing_fraction(system.count, system.diameter, *packing);

    Key const given = side ? side_key : packing_key;
    double const ratio = largest_side_in_diameters(scene.precision);
    if (!(system.side <= ratio * system.diameter))
        throw document.mistake(
            given,
            fmt::format("the side is {:.4g} diameters, and this precision tells places apart "
                        "up to {:.4g}; {}",
                        system.side / system.diameter, ratio,
                        scene.precision == Precision::single_
                            ? "use more balls or precision = \"double\""
                            : "make the cube smaller"));
    auto const reason = why_it_does_not_fit(
        system, scene.arrangement, side ? CubeGivenBy::side : CubeGivenBy::packing_fraction);
    if (!reason.empty()) throw document.mistake(given, reason);
}

void read_velocities(Document const& document, Scene& scene) {
    auto const [smallest, largest] = magnitudes(scene.precision);
    scene.distribution = required(
        document, distribution_key,
        document.choice<Distribution>(distribution_key, {{"maxwell", Distribution::maxwell},
                                                         {"equal_speed", Distribution::equal_speed},
                                                         {"explicit", Distribution::explicit_},
                                                         {"file", Distribution::file}}),
        "say how the velocities are drawn: maxwell, equal_speed, explicit or file");
    Key const temperature_key{"velocities", "temperature"};
    scene.temperature = document.number(temperature_key, {0, largest, "an energy, kT"}).value_or(1);
    if (scene.temperature > 0 && scene.temperature < smallest)
        throw document.mistake(
            temperature_key,
            fmt::format("must be 0 or lie in [{:.4g}, {:.4g}], an energy, kT", smallest, largest));

    bool const listed = scene.distribution == Distribution::explicit_;
    refuse_unless(listed, document, velocities_key,
                  "goes with distribution = \"explicit\" only; remove it or change distribution");
    if (!listed) return;
    scene.velocities = required(document, velocities_key, document.vectors(velocities_key, largest),
                                "distribution = \"explicit\" needs [x, y, z] for each ball");
    if (scene.velocities.cols() != scene.system.count)
        throw document.mistake(velocities_key,
                               fmt::format("must list count = {} balls, and lists {}; make them "
                                           "agree",
                                           scene.system.count, scene.velocities.cols()));
}

/// The trajectory that places or velocities come from; a relative path starts at the scene's
/// folder.
void read_start_path(Document const& document, Scene& scene) {
    bool const places = scene.arrangement == Arrangement::file;
    bool const velocities = scene.distribution == Distribution::file;
    refuse_unless(places, document, start_path_key,
                  "goes with arrangement = \"file\" only; remove it or change arrangement");
    refuse_unless(velocities && !places, document, velocity_path_key,
                  "goes with distribution = \"file\" only, and not beside a path of [balls]; "
                  "remove it");
    if (!places && !velocities) return;
    Key const key = places ? start_path_key : velocity_path_key;
    std::filesystem::path const path =
        required(document, key, document.string(key), "name the trajectory to start from");
    if (path.empty()) throw document.mistake(key, "must name the trajectory to start from");
    scene.start_path = (std::filesystem::path(scene.source).parent_path() / path).string();
}

void read_goal(Document const& document, Scene& scene) {
    double const count = static_cast<double>(scene.system.count);
    Range const per_ball{0, 2 * most_collisions / count, "collisions per ball"};
    scene.equilibrate = document.number({"run", "equilibrate"}, per_ball).value_or(0);
    scene.collisions_per_ball = document.number(per_ball_key, per_ball);
    if (scene.collisions_per_ball == 0.0)
        throw document.mistake(per_ball_key, "must be above 0, or there is nothing to run");
    scene.time = document.number(time_key, {0, magnitudes(Precision::double_).largest, "a time"});
    auto const collisions =
        document.whole_number(collisions_key, 1, static_cast<std::int64_t>(most_collisions));
    if (collisions) scene.collisions = static_cast<std::uint64_t>(*collisions);

    int const goals = scene.collisions_per_ball.has_value() + scene.time.has_value() +
                      scene.collisions.has_value();
    if (goals == 1) return;
    std::string const rule = "give exactly one of collisions_per_ball, time and collisions";
    if (goals == 0) throw document.missing(per_ball_key, rule);
    throw document.mistake(scene.collisions ? collisions_key : time_key,
                           "is one goal too many; " + rule);
}

void read_output(Document const& document, Scene& scene) {
    scene.frame_interval =
        document.number(frames_key, {0, magnitudes(Precision::double_).largest, "a time"})
            .value_or(0);
    if (scene.time && scene.frame_interval > 0 && *scene.time / scene.frame_interval > most_frames)
        throw document.mistake(
            frames_key, fmt::format("makes {:.4g} frames of time = {}, above {:.4g}; raise "
                                    "it",
                                    *scene.time / scene.frame_interval, *scene.time, most_frames));
    scene.events =
        document.flag({"output", "events"}).value_or(false) ? Events::stored : Events::dropped;
}

} // namespace

Scene parse_scene(std::string const& text, std::string const& source,
                  std::vector<std::string> const& overrides) {
    Document const document(text, source, overrides);
    Scene scene;
    scene.source = source;
    scene.text = document.text();
    scene.title = document.string({"", "title"}).value_or("");
    scene.seed = static_cast<std::uint64_t>(
        document.whole_number({"run", "seed"}, 0, std::numeric_limits<std::int64_t>::max())
            .value_or(0));
    read_model(document, scene); // first: how large numbers may be depends on the precision
    read_balls(document, scene);
    read_container(document, scene);
    read_velocities(document, scene);
    read_start_path(document, scene);
    read_goal(document, scene);
    read_output(document, scene);
    return scene;
}

Scene read_scene(std::string const& path, std::vector<std::string> const& overrides) {
    std::error_code unknown; // a file that cannot be asked is one that cannot be opened
    if (std::filesystem::is_directory(path, unknown))
        throw input_error(fmt::format("{}: is a directory; name a scene file (.toml)", path));
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw input_error(fmt::format("{}: {}; name a scene file (.toml)", path,
                                      std::filesystem::exists(path, unknown) ? "cannot be read"
                                                                             : "no such file"));
    std::string text;
    // One block at a time with an end in sight: the path may name a pipe or an endless device.
    for (char block[1 << 16]; file.read(block, sizeof block) || file.gcount() > 0;) {
        text.append(block, static_cast<std::size_t>(file.gcount()));
        if (text.size() > largest_scene_file)
            throw input_error(
                fmt::format("{}: is larger than {} MiB; keep many balls in a file and "
                            "use arrangement = \"file\"",
                            path, largest_scene_file >> 20));
    }
    if (file.bad())
        throw input_error(fmt::format("{}: cannot be read to its end; copy it anew", path));
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        throw input_error(fmt::format("{}: is empty; a scene needs [container], [balls], "
                                      "[velocities] and [run]",
                                      path));
    return parse_scene(text, path, overrides);
}

} // namespace clack
