// Balls in rows and planes, and what is said of their speeds.

#include "tests/scenes/scene_text.hpp"

#include "view/confinement.hpp"
#include "view/live.hpp"
#include "view/physics.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <numeric>

using namespace clack;
using namespace clack::test;
using namespace clack::view;

namespace {

Live live(std::string const& text) { return Live(parse_scene(text, "scene.toml")); }

/// Four balls, the first of which goes along x, with other places.
std::string four_at(std::string const& places) {
    return changed(four_balls, "[[1, 1, 1], [3, 1, 1], [5, 1, 1], [7, 1, 1]]", places);
}

int directions_of(std::string const& text) {
    auto const source = live(text);
    return directions_of_motion(source.system(), source.snapshot());
}

std::vector<double> sorted_speeds(Live const& source) {
    auto const now = source.snapshot();
    std::vector<double> speeds;
    for (Eigen::Index ball = 0; ball < now.velocities.cols(); ++ball)
        speeds.push_back(now.velocities.col(ball).norm());
    std::sort(speeds.begin(), speeds.end());
    return speeds;
}

Physics physics_now(Live const& source) {
    auto const now = source.sample();
    return physics_of(frame_of(source, nullptr), {{0, {}, now.kinetic_energy}, now});
}

} // namespace

BOOST_AUTO_TEST_CASE(rows_and_planes_are_told_from_space) {
    BOOST_TEST(directions_of(four_balls) == 1);
    // A second row, as far away as a ball is wide or less.
    BOOST_TEST(directions_of(four_at("[[1, 1, 1], [3, 1, 1], [1, 2, 1], [3, 2, 1]]")) == 1);
    BOOST_TEST(directions_of(four_at("[[1, 1, 1], [3, 1, 1], [5, 1.9, 1], [7, 1.9, 1]]")) == 2);
    BOOST_TEST(directions_of(four_at("[[1, 1, 1], [3, 1, 1], [5, 1.9, 1], [7, 1, 1.1]]")) == 3);
    auto const slanted = changed(four_balls, "[[1, 0, 0],", "[[1, 0, 0.5],");
    BOOST_TEST(directions_of(slanted) == 2);
}

BOOST_AUTO_TEST_CASE(rows_touch_across_a_periodic_face) {
    auto const periodic = changed(four_balls, "walls", "periodic");
    auto const second_row_at = [&](std::string const& y) {
        auto const place = y + ", 1]";
        return changed(periodic, "[3, 1, 1], [5, 1, 1], [7, 1, 1]",
                       "[3, 1, 1], [5, " + place + ", [7, " + place);
    };
    BOOST_TEST(directions_of(second_row_at("9.9")) == 1);
    BOOST_TEST(directions_of(second_row_at("0.1")) == 2);
    BOOST_TEST(directions_of(changed(second_row_at("9.9"), "[1, 1, 1], [3, 1,",
                                     "[1, 0.8, 1], [3, 0.8,")) == 2);
}

BOOST_AUTO_TEST_CASE(a_row_hands_its_speeds_on_and_is_shown_no_law) {
    auto row = live(four_balls);
    auto const at_start = sorted_speeds(row);
    for (int collision = 0; collision < 200; ++collision) BOOST_REQUIRE(row.step());
    BOOST_TEST(sorted_speeds(row) == at_start);
    auto const physics = physics_now(row);
    BOOST_TEST(physics.directions == 1);
    BOOST_TEST(physics.without_law.find("hand on") != std::string::npos);
    BOOST_TEST((physics.speeds.maxwell.empty() && physics.speeds.exact.empty()));
    BOOST_TEST((!physics.speed_test && !physics.compressibility_factor.wall));
    BOOST_TEST(physics.course.empty());
    auto const& measured = physics.speeds.measured;
    BOOST_TEST(measured.front() == 3 * *std::max_element(measured.begin() + 1, measured.end()));
    // Those in space share theirs.
    auto space = live(four_at("[[1, 1, 1], [3, 1, 1], [5, 1.9, 1], [7, 1, 1.1]]"));
    for (int collision = 0; collision < 200; ++collision) BOOST_REQUIRE(space.step());
    BOOST_TEST(sorted_speeds(space).front() > 0);
    BOOST_TEST(!physics_now(space).speeds.maxwell.empty());
    BOOST_TEST(physics_now(space).compressibility_factor.wall.has_value());
}

BOOST_AUTO_TEST_CASE(one_ball_keeps_its_speed_and_is_shown_no_law) {
    auto const one = changed(changed(changed(four_balls, "count = 4", "count = 1"),
                                     "[[1, 1, 1], [3, 1, 1], [5, 1, 1], [7, 1, 1]]", "[[1, 1, 1]]"),
                             "[[1, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]]", "[[1, 0.5, 0.25]]");
    auto const physics = physics_now(live(one));
    BOOST_TEST(physics.directions == 3);
    BOOST_TEST(physics.without_law.find("one ball") != std::string::npos);
    BOOST_TEST(physics.speeds.maxwell.empty());
}

BOOST_AUTO_TEST_CASE(balls_beyond_the_scale_of_speeds_are_counted) {
    auto const hot = live(changed(
        correct_scene, "\"maxwell\"", "\"explicit\"\nvelocities = [[9, 5, 3]" + [] {
            std::string rest;
            for (int ball = 1; ball < 100; ++ball) rest += ", [0, 0, 0]";
            return rest;
        }() + "]"));
    auto const speeds = physics_now(hot).speeds;
    BOOST_TEST(speeds.beyond == 1u);
    auto const& measured = speeds.measured;
    double const shown = std::accumulate(measured.begin(), measured.end(), 0.0) * speeds.top /
                         static_cast<double>(measured.size());
    BOOST_TEST(std::abs(shown - 0.99) < 1e-6);
}
