#pragma once
// A correct scene, and copies of it with one thing changed.

#include "scenes/scene.hpp"
#include "state/errors.hpp"

#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

namespace clack::test {

inline std::string const correct_scene = R"(title = "a scene"
[container]
boundary = "periodic"
side = 20.0
[balls]
count = 100
arrangement = "fcc"
[velocities]
distribution = "maxwell"
[run]
seed = 7
collisions_per_ball = 10
)";

inline std::string const four_balls = R"([container]
boundary = "walls"
side = 10
[balls]
count = 4
arrangement = "explicit"
positions = [[1, 1, 1], [3, 1, 1], [5, 1, 1], [7, 1, 1]]
[velocities]
distribution = "explicit"
velocities = [[1, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]]
[run]
time = 10
)";

/// The text with `from`, which it must hold, changed to `to`.
inline std::string changed(std::string text, std::string const& from, std::string const& to) {
    auto const place = text.find(from);
    BOOST_REQUIRE_MESSAGE(place != std::string::npos, from);
    return text.replace(place, from.size(), to);
}

/// What the mistake's message says, or nothing when there is none; it must be one line.
template <class Action> std::string message_of(Action action) {
    try {
        action();
    } catch (InputError const& error) {
        std::string const message = error.what();
        BOOST_TEST(message.find('\n') == std::string::npos);
        return message;
    }
    return "";
}

inline std::string parse_message(std::string const& text,
                                 std::vector<std::string> const& overrides = {}) {
    return message_of([&] { parse_scene(text, "scene.toml", overrides); });
}

inline std::string start_message(std::string const& text, StartReader const& read = {}) {
    return message_of([&] { make_start(parse_scene(text, "scene.toml"), read); });
}

/// The beginning of `message`, as long as `expected`: shown side by side where they differ.
inline std::string beginning(std::string const& message, std::string const& expected) {
    return message.substr(0, expected.size());
}

} // namespace clack::test
