// Visits to the window on a virtual display: what is asked for happens, and the picture shows it.

#include "tests/cli/program.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>
#include <png.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

using namespace clack::test;

namespace {

Folder const folder;

using States = std::vector<nlohmann::json>;

std::string const gas = R"(
[container]
boundary = "walls"
side = 8.0
[balls]
count = 27
arrangement = "grid"
[velocities]
distribution = "maxwell"
[run]
seed = 3
time = 3.0
[output]
frame_interval = 0.25
events = true
)";

/// A virtual display for this program alone, which says itself when it is ready.
class Display {
public:
    Display() {
        std::array<int, 2> ends{};
        BOOST_REQUIRE(pipe(ends.data()) == 0);
        server_ = fork();
        if (server_ == 0) {
            auto const ready = std::to_string(ends[1]);
            dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
            execlp("Xvfb", "Xvfb", "-displayfd", ready.c_str(), "-screen", "0", "800x700x24",
                   "-nolisten", "tcp", nullptr);
            _exit(127);
        }
        close(ends[1]);
        std::string number;
        for (char digit = 0; read(ends[0], &digit, 1) == 1 && digit != '\n';) number += digit;
        close(ends[0]);
        BOOST_REQUIRE_MESSAGE(!number.empty(), "Xvfb does not start");
        setenv("DISPLAY", (":" + number).c_str(), 1);
    }
    Display(Display const&) = delete;
    Display& operator=(Display const&) = delete;
    ~Display() {
        kill(server_, SIGTERM);
        waitpid(server_, nullptr, 0);
    }

private:
    pid_t server_ = -1;
};

BOOST_TEST_GLOBAL_FIXTURE(Display);

Outcome visit(std::string const& path, std::string const& commands,
              std::vector<std::string> const& more = {}) {
    auto const script = folder.write("visit.txt", commands);
    std::vector<std::string> words{"view", path, "--visit", script, "--size", "760x640"};
    words.insert(words.end(), more.begin(), more.end());
    return run_clack(words);
}

States states_of(Outcome const& outcome) {
    BOOST_REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
    States states;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);)
        states.push_back(nlohmann::json::parse(line));
    return states;
}

/// Pixels of the picture, left of the panel, that are far brighter than the background.
int bright_pixels(std::string const& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    BOOST_REQUIRE(png_image_begin_read_from_file(&image, path.c_str()));
    image.format = PNG_FORMAT_GRAY;
    std::vector<png_byte> grey(PNG_IMAGE_SIZE(image));
    png_image_finish_read(&image, nullptr, grey.data(), 0, nullptr);
    int count = 0;
    for (std::size_t i = 0; i < grey.size(); ++i) count += i % image.width < 430 && grey[i] > 60;
    return count;
}

} // namespace

BOOST_AUTO_TEST_CASE(steps_go_from_collision_to_collision_and_back_to_the_same_bits) {
    auto const states =
        states_of(visit(folder.write("gas.toml", gas),
                        "print\nkey right\nprint\nkey right\nprint\nkey left\nprint\n"
                        "key left\nprint\n"));
    BOOST_REQUIRE(states.size() == 5u);
    for (std::size_t k = 0; k < 3; ++k) BOOST_TEST(states[k]["collisions"] == k);
    // What was foretold came true.
    BOOST_TEST(states[1]["time"].get<double>() == states[0]["next_time"].get<double>());
    BOOST_TEST(states[2]["time"].get<double>() == states[1]["next_time"].get<double>());
    for (auto const* const key : {"time", "first_x", "collisions", "next_time"})
        BOOST_TEST(states[3][key] == states[1][key]);
    BOOST_TEST(states[4]["collisions"] == 0);
}

BOOST_AUTO_TEST_CASE(it_plays_pauses_and_tells_its_speed) {
    auto const states =
        states_of(visit(folder.write("gas.toml", gas), "key up\nkey space\nwait 1.5\nprint\n"
                                                       "key space\nprint\nwait 0.3\nprint\n"));
    BOOST_TEST(states[0]["playing"] == true);
    BOOST_TEST(states[0]["speed"] == 2.0);
    BOOST_TEST(states[0]["time"].get<double>() > 0.5);
    BOOST_TEST(states[0]["collisions"].get<int>() > 0);
    BOOST_TEST(states[1]["playing"] == false);
    BOOST_TEST(states[2]["time"] == states[1]["time"]);
}

BOOST_AUTO_TEST_CASE(a_leap_in_time_is_no_speed) {
    std::string commands = "key space\nwait 0.7\nseek 500\n";
    for (int print = 0; print < 6; ++print) commands += "wait 0.2\nprint\n"; // a speed lasts 0.5 s
    for (auto const& state : states_of(visit(folder.write("gas.toml", gas), commands))) {
        BOOST_TEST(state["playing"] == true);
        BOOST_TEST(state["time"].get<double>() > 500);
        BOOST_TEST(state["true_speed"].get<double>() > 0.1);
        BOOST_TEST(state["true_speed"].get<double>() < 2); // asked for is 1
    }
}

BOOST_AUTO_TEST_CASE(a_click_follows_a_ball_and_an_empty_place_lets_go) {
    // The ball in the middle of the cube is in the middle of the picture.
    auto const one = folder.write("one.toml", R"(
[container]
boundary = "walls"
side = 5.0
[balls]
count = 1
arrangement = "explicit"
positions = [[2.5, 2.5, 2.5]]
[velocities]
distribution = "explicit"
velocities = [[1.0, 0.5, 0.25]]
[run]
time = 10.0
)");
    auto const states =
        states_of(visit(one, "click 215 320\nprint\nkey right\nkey right\nprint\n"
                             "click 5 5\nprint\nsave " +
                                 folder.file("one.png") + "\nkey ?\nwait 0.2\nsave " +
                                 folder.file("keys.png") + "\n"));
    BOOST_TEST(states[0]["traced"] == 0);
    BOOST_TEST(states[0]["balls"] == 1);
    BOOST_TEST(states[1]["bends"] == 3);
    BOOST_TEST(states[2]["traced"] == -1);
    auto const pixels_of_one = bright_pixels(folder.file("one.png"));
    BOOST_TEST(pixels_of_one > 1000);
    constexpr int letters = 400, pixels_of_letter = 8; // in the list of keys, at least
    BOOST_TEST(bright_pixels(folder.file("keys.png")) > pixels_of_one + letters * pixels_of_letter);
}

BOOST_AUTO_TEST_CASE(another_scene_starts_cleanly_and_an_impossible_one_is_told) {
    auto const saved = folder.file("dense.png");
    auto const states = states_of(visit(
        folder.write("gas.toml", gas),
        "key right\nchoose balls 125\nchoose packing_fraction 0.3\nchoose method table\nstart\n"
        "print\nsave " +
            saved +
            "\nkey ?\nkey c\nkey x\nkey n\nkey b\nkey p\n"
            "choose packing_fraction 0.9\nstart\nprint\n"));
    BOOST_TEST(states[0]["balls"] == 125);
    BOOST_TEST(states[0]["time"] == 0.0);
    BOOST_TEST(states[0]["collisions"] == 0);
    BOOST_TEST(states[0]["description"].get<std::string>().find("EveryPair") != std::string::npos);
    BOOST_TEST(states[1]["balls"] == 125);
    BOOST_TEST(states[1]["message"].get<std::string>().find("packing_fraction") !=
               std::string::npos);
    BOOST_TEST(bright_pixels(saved) > 15'000);
}

BOOST_AUTO_TEST_CASE(another_seed_starts_anew_with_other_velocities) {
    auto const states = states_of(visit(folder.write("gas.toml", gas),
                                        "print\nkey right\nkey s\nprint\nchoose seed 3\nstart\n"
                                        "print\ndrag 30 10\nscroll 1\nprint\n"));
    BOOST_TEST(states[1]["time"] == 0.0);
    BOOST_TEST(states[1]["next_time"] != states[0]["next_time"]);
    BOOST_TEST(states[2]["next_time"] == states[0]["next_time"]);
    BOOST_TEST(states[3]["answer"].get<double>() > 0); // a picture has shown the turn
    BOOST_TEST(states[3]["answer"].get<double>() < 5);
}

BOOST_AUTO_TEST_CASE(a_corrupt_file_is_refused) {
    auto const outcome = visit(folder.write("corrupt.h5", std::string(5000, 'x')), "print\n");
    BOOST_TEST(outcome.code == 2);
    BOOST_TEST(outcome.err_is_one_line());
    BOOST_TEST(outcome.err.find("not an HDF5 file") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_file_is_replayed_exactly_between_its_frames) {
    auto const scene = folder.write("gas.toml", gas);
    auto const file = folder.file("gas.h5");
    BOOST_REQUIRE(run_clack({"run", scene, "-o", file, "--quiet"}).code == 0);
    std::string const script = "seek 1.625\nprint\nkey right\nprint\nkey left\nprint\nseek 0\n"
                               "key right\nprint\n";
    auto const replayed = states_of(visit(file, script));
    auto const live = states_of(visit(scene, script));
    for (std::size_t k = 0; k < live.size(); ++k) {
        for (auto const* const key : {"collisions", "ball_collisions"})
            BOOST_TEST(replayed[k][key] == live[k][key]);
        BOOST_TEST(std::abs(replayed[k]["time"].get<double>() - live[k]["time"].get<double>()) <
                   1e-12);
        BOOST_TEST(std::abs(replayed[k]["first_x"].get<double>() -
                            live[k]["first_x"].get<double>()) < 1e-11);
    }
    BOOST_TEST(replayed[0]["last_time"] == 3.0);
}

BOOST_AUTO_TEST_CASE(a_file_that_grows_is_followed) {
    auto const long_run = folder.write(
        "long.toml", std::string(gas).replace(gas.find("time = 3.0"), 10, "time = 1e8"));
    auto const file = folder.file("long.h5");
    Process writer({"run", long_run, "-o", file, "--quiet", "--set", "output.events=false", "--set",
                    "output.frame_interval=50.0"});
    writer.wait_for(file);
    auto const outcome = visit(file, "print\npick 5\nwait 1.5\nprint\n");
    auto const states = states_of(outcome);
    BOOST_TEST(outcome.err.empty()); // whatever the file is in the middle of
    writer.signal_after({}, SIGINT);
    writer.finish();
    BOOST_TEST(states[1]["last_time"].get<double>() > states[0]["last_time"].get<double>());
    BOOST_TEST(states[0]["remark"].get<std::string>().find("from frame to frame") !=
               std::string::npos);
    // A ball can be followed, but nobody knows its path and what is next.
    BOOST_TEST((states[1]["traced"] == 5 && states[1]["bends"] == 0));
    BOOST_TEST(states[1]["unforetold"].get<std::string>().find("not known") == 0u);
    std::filesystem::remove(file);
}

BOOST_AUTO_TEST_CASE(without_a_display_there_is_a_line) {
    auto const outcome =
        run_clack({"view", folder.write("gas.toml", gas)}, {"env", "-u", "DISPLAY"});
    BOOST_TEST(outcome.code == 2);
    BOOST_TEST(outcome.err_is_one_line());
    BOOST_TEST(outcome.err.find("no window system") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_visit_that_makes_no_sense_is_refused) {
    auto const outcome = visit(folder.write("gas.toml", gas), "print\njump 3\n");
    BOOST_TEST(outcome.code == 2);
    BOOST_TEST(outcome.err.find(":2: jump 3") != std::string::npos);
    auto const unknown = visit(folder.write("gas.toml", gas), "key space\n\nkey any\n");
    BOOST_TEST(unknown.code == 2);
    BOOST_TEST(unknown.err_is_one_line());
    BOOST_TEST(unknown.err.find(":3: key any: no such key") != std::string::npos);
}
