#include "tests/scenes/scene_text.hpp"

using namespace clack;
using namespace clack::test;

namespace {

struct Mistake {
    std::string from, to, message;
};

void check(std::string const& text, std::vector<Mistake> const& mistakes) {
    for (auto const& [from, to, expected] : mistakes) {
        auto const message = start_message(changed(text, from, to));
        BOOST_TEST_MESSAGE(message);
        BOOST_TEST(beginning(message, expected) == expected, message << "  FOR  " << to);
    }
}

std::string const side = "side = 20.0";
std::string const goal = "collisions_per_ball = 10";

} // namespace

BOOST_AUTO_TEST_CASE(correct_scenes_are_accepted) {
    BOOST_TEST(start_message(correct_scene) == "");
    BOOST_TEST(start_message(four_balls) == "");
}

BOOST_AUTO_TEST_CASE(text_that_is_not_toml_is_refused_with_its_line) {
    check(correct_scene, {{"[balls]", "[(balls]", "not TOML: "},
                          {"count = 100", "count = ", "not TOML: "},
                          {"seed = 7", "seed = 7\nseed = 8", "not TOML: "},
                          {"[balls]", std::string("\0", 1), "not TOML: "},
                          {"a scene", "\xff\xfe", "not TOML: "}});
    auto const message = start_message(changed(correct_scene, "count = 100", "count = 1 2"));
    BOOST_TEST(message.find("(scene.toml:6)") != std::string::npos, message);
}

BOOST_AUTO_TEST_CASE(names_too_deep_for_the_parser_are_refused) {
    std::string name = "a";
    for (int part = 0; part < 200000; ++part) name += ".a";
    std::string const expected = "not TOML: a name of more than 1000 parts (scene.toml:2)";
    BOOST_TEST(parse_message("# deep\n" + name + " = 1") == expected);
    BOOST_TEST(parse_message("# deep\n[" + name + "]") == expected);
}

BOOST_AUTO_TEST_CASE(unknown_sections_and_keys_are_refused) {
    check(correct_scene,
          {{"[run]", "[walk]", "[walk]: not a section or key of a scene"},
           {"title", "tilte", "tilte: not a section or key of a scene"},
           {"title", "\"\"", "\"\": not a section or key of a scene"},
           {"seed", "sead", "sead = 7: not a key of [run], which takes seed, "},
           {"[balls]", "[[balls]]", "balls = [...]: must be a section; write [balls]"},
           {"title = \"a scene\"", "run = 3", "not TOML: "},
           {"[run]\nseed = 7\n" + goal, "", "[run] is missing: a scene needs [container]"},
           {"[velocities]\ndistribution = \"maxwell\"", "", "[velocities] is missing: "}});
    BOOST_TEST(parse_message("container = 3") ==
               "container = 3: must be a section; write [container] on a line of its own "
               "(scene.toml:1)");
}

BOOST_AUTO_TEST_CASE(missing_keys_are_named) {
    check(correct_scene,
          {{"count = 100", "", "count is missing from [balls]: "},
           {"arrangement = \"fcc\"", "", "arrangement is missing from [balls]: "},
           {"boundary = \"periodic\"", "", "boundary is missing from [container]: "},
           {"distribution = \"maxwell\"", "", "distribution is missing from [velocities]: "},
           {side, "", "side is missing from [container]: give exactly one of side and "},
           {goal, "", "collisions_per_ball is missing from [run]: give exactly one of "},
           {"\"fcc\"", "\"explicit\"", "positions is missing from [balls]: "},
           {"\"fcc\"", "\"file\"", "path is missing from [balls]: "},
           {"\"maxwell\"", "\"explicit\"", "velocities is missing from [velocities]: "},
           {"\"maxwell\"", "\"file\"", "path is missing from [velocities]: "}});
}

BOOST_AUTO_TEST_CASE(wrong_types_are_refused) {
    check(correct_scene,
          {{"\"a scene\"", "3", "title = 3: must be text in quotes (scene.toml:1)"},
           {"\"periodic\"", "true", "boundary = true: must be text in quotes (scene.toml:3)"},
           {"20.0", "\"20\"", "side = \"20\": must be a number, a length (scene.toml:4)"},
           {"20.0", "[20]", "side = [...]: must be a number"},
           {"20.0", "{ a = 1 }", "side = {...}: must be a number"},
           {"20.0", "1979-05-27", "side = a date or time: must be a number"},
           {"count = 100", "count = 100.0", "count = 100.0: must be a whole number from 1 to "},
           {"count = 100", "count = \"many\"", "count = \"many\": must be a whole number"},
           {"seed = 7", "seed = 7.5", "seed = 7.5: must be a whole number from 0 to "},
           {goal, "collisions = 1e3", "collisions = 1000.0: must be a whole number from 1 to "},
           {goal, goal + "\n[output]\nevents = 1", "events = 1: must be true or false"}});
}

BOOST_AUTO_TEST_CASE(numbers_out_of_range_are_refused) {
    check(correct_scene,
          {{"count = 100", "count = 0", "count = 0: must be a whole number from 1 to 134217727"},
           {"count = 100", "count = -5", "count = -5: must be a whole number from 1"},
           {"count = 100", "count = 134217728", "count = 134217728: must be a whole number"},
           {"count = 100", "count = 99999999999999999999", "not TOML: "},
           {"20.0", "nan", "side = nan: must be a finite number, a length (scene.toml:4)"},
           {"20.0", "-inf", "side = -inf: must be a finite number, a length (scene.toml:4)"},
           {"20.0", "-20.0", "side = -20.0: must lie in [1e-50, 1e+50], a length"},
           {"20.0", "0", "side = 0: must lie in"},
           {"20.0", "1e300", "side = 1e+300: must lie in"},
           {"20.0", "1e10", "side = 10000000000.0: the side is 1e+10 diameters, and "},
           {"count = 100", "count = 100\ndiameter = 0", "diameter = 0: must lie in"},
           {"count = 100", "count = 100\nmass = -1", "mass = -1: must lie in"},
           {"seed = 7", "seed = -1", "seed = -1: must be a whole number from 0"},
           {"seed = 7", "equilibrate = -1", "equilibrate = -1: must lie in [0, "},
           {goal, "collisions_per_ball = 0", "collisions_per_ball = 0: must be above 0"},
           {goal, "collisions_per_ball = -1", "collisions_per_ball = -1: must lie in [0, 2e+16]"},
           {goal, "collisions = 0", "collisions = 0: must be a whole number from 1"},
           {goal, "time = -1.5", "time = -1.5: must lie in [0, "},
           {goal, "time = nan", "time = nan: must be a finite number, a time"},
           {goal, "time = 1e40", "time = 1e+40: the fastest ball crosses the cube "},
           {"\"maxwell\"", "\"maxwell\"\ntemperature = -1", "temperature = -1: must lie in [0, "},
           {"\"maxwell\"", "\"maxwell\"\ntemperature = 1e-60", "temperature = 1e-60: must be 0 or"},
           {goal, goal + "\n[output]\nframe_interval = -1", "frame_interval = -1: must lie in"},
           {goal, goal + "\n[output]\nframe_interval = 1e-12", "frame_interval = 1e-12: must be 0"},
           {goal, "time = 1\n[output]\nframe_interval = 1e-10", "frame_interval = 1e-10: makes"},
           {goal, goal + "\nprecision = \"float\"\nequilibrate = -1", "equilibrate = -1"}});
}

BOOST_AUTO_TEST_CASE(float_takes_smaller_scenes_only) {
    auto const text = changed(correct_scene, goal, goal + "\nprecision = \"float\"");
    check(text, {{side, "side = 1600", "side = 1600: the side is 1600 diameters, and this "},
                 {side, "side = 1e7", "side = 10000000.0: must lie in [1e-06, 1e+06]"},
                 {side, "packing_fraction = 1e-9", "packing_fraction = 1e-09: the side is "}});
}

BOOST_AUTO_TEST_CASE(words_that_are_no_choice_are_refused_with_the_choices) {
    check(correct_scene,
          {{"periodic", "open", "boundary = \"open\": must be one of walls, periodic (scene"},
           {"fcc", "bcc", "arrangement = \"bcc\": must be one of grid, fcc, random, explicit, f"},
           {"maxwell", "normal", "distribution = \"normal\": must be one of maxwell, equal_speed"},
           {goal, goal + "\nmethod = \"slow\"",
            "method = \"slow\": must be one of auto, table, heap, fast (scene.toml:13)"},
           {goal, goal + "\nprecision = \"half\"",
            "precision = \"half\": must be one of float, double, long double, quad"}});
}

BOOST_AUTO_TEST_CASE(one_of_side_and_packing_fraction_and_one_goal) {
    check(correct_scene,
          {{side, side + "\npacking_fraction = 0.1",
            "packing_fraction = 0.1: excludes side, which is given too; keep one of them"},
           {goal, goal + "\ntime = 3", "time = 3: is one goal too many; give exactly one of"},
           {goal, goal + "\ncollisions = 3", "collisions = 3: is one goal too many"},
           {goal, "time = 3\ncollisions = 3", "collisions = 3: is one goal too many"}});
}

BOOST_AUTO_TEST_CASE(keys_that_the_choice_has_no_use_for_are_refused) {
    check(correct_scene,
          {{"\"fcc\"", "\"fcc\"\npositions = [[1, 2, 3]]", "positions = [...]: goes with arr"},
           {"\"fcc\"", "\"fcc\"\npath = \"start.h5\"", "path = \"start.h5\": goes with arr"},
           {"\"maxwell\"", "\"maxwell\"\nvelocities = []", "velocities = [...]: goes with dis"},
           {"\"maxwell\"", "\"maxwell\"\npath = \"a\"", "path = \"a\": goes with distribution"}});
}

BOOST_AUTO_TEST_CASE(packing_fractions_beyond_what_fits_are_refused) {
    std::string const packing = "packing_fraction = ";
    check(correct_scene,
          {{side, packing + "0.75",
            "packing_fraction = 0.75: must lie in (0, 0.7405), close packing; lower it (scene.to"},
           {side, packing + "0", "packing_fraction = 0: must lie in (0, 0.7405), close packing; r"},
           {side, packing + "-0.1", "packing_fraction = -0.1: must lie in (0, 0.7405)"},
           {side, packing + "nan", "packing_fraction = nan: must be a finite number"},
           {side, packing + "1e-40", "packing_fraction = 1e-40: the side is "},
           {side, packing + "0.70",
            "packing_fraction = 0.7: 100 balls in an fcc arrangement with periodic images fit up "
            "to 0.6856; lower it"},
           {side, "side = 4",
            "side = 4: 100 balls in an fcc arrangement with periodic images would have packing "
            "fraction 0.8181 and fit up to 0.6856; raise side to 4.24264 or take at most 32 balls"},
           {side, "side = 1.1",
            "side = 1.1: 100 balls in an fcc arrangement with periodic images would have packing "
            "fraction 39.34 and fit up to 0.6856; raise side to 4.24264 or lower the diameter"}});
    check(changed(correct_scene, "periodic", "walls"),
          {{side, packing + "0.6",
            "packing_fraction = 0.6: 100 balls in an fcc arrangement between walls fit up to 0."},
           {side, "side = 4.5",
            "side = 4.5: 100 balls in an fcc arrangement between walls would have"}});
    check(
        changed(correct_scene, "fcc", "grid"),
        {{side, packing + "0.45",
          "packing_fraction = 0.45: 100 balls on a simple cubic grid with periodic images fit "
          "up to 0.4188; lower it"},
         {side, "side = 4.5", "side = 4.5: 100 balls on a simple cubic grid with periodic imag"}});
    check(changed(correct_scene, "fcc", "random"),
          {{side, packing + "0.61",
            "packing_fraction = 0.61: 100 balls placed at random with peri"
            "odic images fit up to 0.6000; lower it"}});
    check(four_balls, {{"side = 10", "side = 1.2",
                        "side = 1.2: 4 balls in any arrangement between walls would have packing "
                        "fraction 1.212 and fit up to 0.7404; raise side to 1.41"}});
}

BOOST_AUTO_TEST_CASE(lists_that_are_wrong_are_refused) {
    check(
        four_balls,
        {{"count = 4", "count = 5", "positions = [...]: must list count = 5 balls, and lists 4"},
         {", [0, 0, 0]]", "]", "velocities = [...]: must list count = 4 balls, and lists 3"},
         {"[[1, 1, 1], ", "[[1, 1], ", "positions[0]: must be a list of three numbers, [x, y, z]"},
         {"[3, 1, 1]", "3", "positions[1] = 3: must be a list of three numbers"},
         {"[[1, 1, 1], [3, 1, 1], [5, 1, 1], [7, 1, 1]]", "7", "positions = 7: must be a list"},
         {"[3, 1, 1]", "[3, nan, 1]", "positions[1][1] = nan: must be a finite number of size "},
         {"[3, 1, 1]", "[3, 1, \"a\"]", "positions[1][2] = \"a\": must be a finite number"},
         {"[1, 0, 0]", "[inf, 0, 0]", "velocities[0][0] = inf: must be a finite number"},
         {"[1, 0, 0]", "[1e60, 0, 0]", "velocities[0][0] = 1e+60: must be a finite number"},
         {"[1, 0, 0]", "[1e-60, 0, 0]",
          "distribution = \"explicit\": the fastest ball has speed 1e-60, which must "}});
}

BOOST_AUTO_TEST_CASE(places_that_are_wrong_are_refused_by_ball) {
    check(four_balls,
          {{"[3, 1, 1]", "[1.75, 1, 1]", "balls 0 and 1 overlap by 0.25 diameters: centres must "},
           {"[3, 1, 1]", "[1, 1, 1]", "balls 0 and 1 overlap by 1 diameters: "},
           {"[7, 1, 1]", "[9.6, 1, 1]",
            "ball 3 has x = 9.6: sticks out of the cube, the centre must lie in "
            "[0.5, 9.5], half a diameter from the walls"},
           {"[7, 1, 1]", "[7, 0.4, 1]", "ball 3 has y = 0.4: sticks out of the cube"},
           {"[7, 1, 1]", "[7, 1, -3]", "ball 3 has z = -3: sticks out of the cube"}});
    check(changed(four_balls, "walls", "periodic"),
          {{"[7, 1, 1]", "[-8.5, 1, 1]", "balls 0 and 3 overlap by 0.5 diameters: "},
           {"[7, 1, 1]", "[10.25, 1, 1]", "balls 0 and 3 overlap by 0.25 diameters: "},
           {"[7, 1, 1]", "[1e9, 1, 1]",
            "ball 3 has x = 1000000000: must lie in [-10000000, 10000000]; move it"}});
}

BOOST_AUTO_TEST_CASE(a_list_over_many_lines_shows_the_line_of_the_ball) {
    auto const text = changed(four_balls, "[3, 1, 1], [5, 1, 1]", "\n[3, 1, 1],\n[3.5, 1, 1]");
    BOOST_TEST(start_message(text) ==
               "balls 1 and 2 overlap by 0.5 diameters: centres must be at least diameter = 1 "
               "apart; move them or make them smaller (scene.toml:9)");
}

BOOST_AUTO_TEST_CASE(the_deepest_overlap_is_the_one_named) {
    check(four_balls, {{"[3, 1, 1], [5, 1, 1]", "[1.75, 1, 1], [1.85, 1, 1]",
                        "balls 1 and 2 overlap by 0.9 diameters: "}});
}

BOOST_AUTO_TEST_CASE(goals_that_nothing_can_reach_are_refused) {
    check(changed(four_balls, "[1, 0, 0]", "[0, 0, 0]"),
          {{"time = 10", "collisions = 10",
            "collisions = 10: is never reached, for all velocities are zero: nothing will ever "
            "happen"},
           {"time = 10", "time = 10\nequilibrate = 1",
            "equilibrate = 1: is never reached, for all"}});
    check(correct_scene,
          {{"\"maxwell\"", "\"maxwell\"\ntemperature = 0",
            "collisions_per_ball = 10: is never reached, for all velocities are zero"},
           {"count = 100", "count = 1",
            "collisions_per_ball = 10: is never reached, for a single ball has no other"}});
}

BOOST_AUTO_TEST_CASE(nothing_that_moves_is_fine_where_the_goal_is_a_time) {
    BOOST_TEST(start_message(changed(four_balls, "[1, 0, 0]", "[0, 0, 0]")) == "");
    auto const timed = changed(correct_scene, goal, "time = 3");
    BOOST_TEST(start_message(changed(timed, "count = 100", "count = 1")) == "");
    BOOST_TEST(start_message(changed(timed, "\"maxwell\"", "\"maxwell\"\ntemperature = 0")) == "");
}

BOOST_AUTO_TEST_CASE(balls_slower_than_the_clock_can_follow_are_refused) {
    auto const at_rest = changed(four_balls, "[1, 0, 0]", "[0, 0, 0]");
    BOOST_TEST(start_message(changed(at_rest, "time = 10", "time = 1e37")) == "");
    check(at_rest,
          {{"time = 10", "time = 1e38", "time = 1e+38: is above 1e+37, the longest that"}});
    auto const endless = changed(four_balls, "time = 10", "time = 1e50");
    // Squares of such speeds vanish, and with them the epoch of the clock.
    check(endless,
          {{"[1, 0, 0]", "[1e-170, 0, 0]",
            "distribution = \"explicit\": the fastest ball has speed 1e-170, which must"}});
    BOOST_TEST(start_message(changed(endless, "[1, 0, 0]", "[1e-40, 0, 0]")) == "");
}
