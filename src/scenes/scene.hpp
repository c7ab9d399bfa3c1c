#pragma once
// How a run starts and what is asked of it: the scene file, read and checked.

#include "simulation/engine.hpp"
#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace clack {

enum class Arrangement { grid, fcc, random, explicit_, file };
enum class Distribution { maxwell, equal_speed, explicit_, file };
enum class Events { dropped, stored };

/// A scene file after every rule has been checked but the ones that need the balls in place.
struct Scene {
    std::string title;
    std::string source; // the file's name, for messages
    std::string text;   // the scene as it is run: the file's text with the overrides written in

    System system;
    Arrangement arrangement = Arrangement::fcc;
    Eigen::Matrix3Xd positions; // arrangement explicit
    std::string start_path;     // arrangement or distribution file

    Distribution distribution = Distribution::maxwell;
    double temperature = 1;      // kT  [energy]
    Eigen::Matrix3Xd velocities; // distribution explicit

    std::uint64_t seed = 0;
    double equilibrate = 0; // collisions per ball before time 0
    // Exactly one of these three is set.
    std::optional<double> collisions_per_ball;
    std::optional<double> time;
    std::optional<std::uint64_t> collisions;
    Method method = Method::automatic;
    Precision precision = Precision::double_;

    double frame_interval = 0; // 0: first and last only
    Events events = Events::dropped;
};

/// How many collisions there are when each ball takes part in so many, on average.
std::uint64_t collisions_of(double per_ball, std::int64_t count);

/// Reads and checks a scene file; each override is "section.key=value" in TOML.
/// Throws InputError, one line with file, line, key, value and rule.
Scene read_scene(std::string const& path, std::vector<std::string> const& overrides = {});

/// The same from a text; `source` is the name that messages give it.
Scene parse_scene(std::string const& text, std::string const& source,
                  std::vector<std::string> const& overrides = {});

/// Reads the last frame of a trajectory: the io layer's, handed down because it lies above.
using StartReader = std::function<Start(std::string const& path)>;

/// Places the balls and gives them their velocities; the same for the same seed on every machine.
/// Throws InputError when they overlap, stick out, do not fit, or will never collide although the
/// goal is counted in collisions.
Start make_start(Scene const& scene, StartReader const& read_start = {});

} // namespace clack
