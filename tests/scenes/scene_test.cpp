#include "tests/scenes/scene_text.hpp"

#include <filesystem>
#include <fstream>

using namespace clack;
using namespace clack::test;

namespace {

std::string const every_key = R"(title = "all of it"
[container]
boundary = "walls"
side = 12
[balls]
count = 50
diameter = 2
mass = 3
arrangement = "grid"
[velocities]
distribution = "equal_speed"
temperature = 4
[run]
seed = 5
equilibrate = 6
time = 7
method = "heap"
precision = "long double"
[output]
frame_interval = 8
events = true
)";

} // namespace

BOOST_AUTO_TEST_CASE(a_scene_holds_what_its_text_says) {
    Scene const scene = parse_scene(every_key, "all.toml");
    BOOST_TEST(scene.title == "all of it");
    BOOST_TEST(scene.source == "all.toml");
    BOOST_CHECK(scene.system.boundary == Boundary::walls);
    BOOST_TEST(scene.system.side == 12);
    BOOST_TEST(scene.system.count == 50);
    BOOST_TEST(scene.system.diameter == 2);
    BOOST_TEST(scene.system.mass == 3);
    BOOST_CHECK(scene.arrangement == Arrangement::grid);
    BOOST_CHECK(scene.distribution == Distribution::equal_speed);
    BOOST_TEST(scene.temperature == 4);
    BOOST_TEST(scene.seed == 5u);
    BOOST_TEST(scene.equilibrate == 6);
    BOOST_TEST(scene.time.value() == 7);
    BOOST_TEST((!scene.collisions && !scene.collisions_per_ball));
    BOOST_CHECK(scene.method == Method::heap);
    BOOST_CHECK(scene.precision == Precision::extended);
    BOOST_TEST(scene.frame_interval == 8);
    BOOST_CHECK(scene.events == Events::stored);
}

BOOST_AUTO_TEST_CASE(keys_that_are_left_out_have_their_defaults) {
    Scene const scene = parse_scene(correct_scene, "scene.toml");
    BOOST_TEST(scene.system.diameter == 1);
    BOOST_TEST(scene.system.mass == 1);
    BOOST_TEST(scene.temperature == 1);
    BOOST_TEST(scene.equilibrate == 0);
    BOOST_CHECK(scene.method == Method::automatic);
    BOOST_CHECK(scene.precision == Precision::double_);
    BOOST_TEST(scene.frame_interval == 0);
    BOOST_CHECK(scene.events == Events::dropped);
}

BOOST_AUTO_TEST_CASE(lists_are_read_ball_by_ball) {
    Scene const scene = parse_scene(four_balls, "scene.toml");
    BOOST_TEST(scene.positions.cols() == 4);
    BOOST_TEST((scene.positions.col(2) == Eigen::Vector3d(5, 1, 1)));
    BOOST_TEST((scene.velocities.col(0) == Eigen::Vector3d(1, 0, 0)));
}

BOOST_AUTO_TEST_CASE(packing_fraction_gives_the_physical_side) {
    Scene const scene =
        parse_scene(changed(correct_scene, "side = 20.0", "packing_fraction = 0.3"), "scene.toml");
    BOOST_TEST(scene.system.packing_fraction() == 0.3, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(paths_start_at_the_folder_of_the_scene) {
    auto const text = changed(correct_scene, "\"fcc\"", "\"file\"\npath = \"start.h5\"");
    BOOST_TEST(parse_scene(text, "a/b/scene.toml").start_path == "a/b/start.h5");
    BOOST_TEST(parse_scene(text, "scene.toml").start_path == "start.h5");
}

BOOST_AUTO_TEST_CASE(the_text_without_overrides_is_the_original) {
    auto const text = correct_scene + "# a last word";
    BOOST_TEST(parse_scene(text, "scene.toml").text == text);
}

BOOST_AUTO_TEST_CASE(overrides_take_the_place_of_what_the_file_says) {
    Scene const scene =
        parse_scene(correct_scene, "scene.toml",
                    {"run.seed=8", "balls.arrangement=random", "run.method=\"heap\"",
                     "title=another one", "output.events=true", "run.seed=9"});
    BOOST_TEST(scene.seed == 9u);
    BOOST_CHECK(scene.arrangement == Arrangement::random);
    BOOST_CHECK(scene.method == Method::heap);
    BOOST_TEST(scene.title == "another one");
    BOOST_CHECK(scene.events == Events::stored);
}

BOOST_AUTO_TEST_CASE(overrides_of_keys_that_exclude_others_remove_them) {
    Scene const scene =
        parse_scene(correct_scene, "scene.toml", {"container.packing_fraction=0.3", "run.time=20"});
    BOOST_TEST(scene.system.packing_fraction() == 0.3, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(scene.time.value() == 20);
    BOOST_TEST(!scene.collisions_per_ball);
    Scene const back =
        parse_scene(scene.text, "scene.toml", {"container.side=20", "run.collisions=5"});
    BOOST_TEST(back.system.side == 20);
    BOOST_TEST(back.collisions.value() == 5u);
    BOOST_TEST(!back.time);
}

BOOST_AUTO_TEST_CASE(the_text_after_overrides_gives_the_same_scene) {
    auto const text = changed(changed(four_balls, "[1, 0, 0]", "[0.1, 1e-17, -3.3333333333333335]"),
                              "[3, 1, 1]", "[3.0000000000000004, 1.1, 1]");
    Scene const scene = parse_scene(text, "scene.toml",
                                    {"title=\"a \\\"title\\\" \\u00e9 \\\\ 'x' \\n\\t\"",
                                     "run.time=0.1", "run.precision=long double"});
    Scene const again = parse_scene(scene.text, "scene.toml");
    BOOST_TEST(again.title == "a \"title\" \xc3\xa9 \\ 'x' \n\t");
    BOOST_TEST((again.positions == scene.positions));
    BOOST_TEST(again.positions(0, 1) == 3.0000000000000004);
    BOOST_TEST((again.velocities == scene.velocities));
    BOOST_TEST(again.velocities(2, 0) == -3.3333333333333335);
    BOOST_TEST(again.time.value() == 0.1);
    BOOST_CHECK(again.precision == Precision::extended);
    BOOST_TEST(again.text == scene.text);
}

BOOST_AUTO_TEST_CASE(overrides_that_are_wrong_are_named) {
    auto const said = [](std::string const& override_text) {
        return parse_message(correct_scene, {override_text});
    };
    BOOST_TEST(said("run.seed") == "--set run.seed: must read section.key=value, as in run.seed=7");
    BOOST_TEST(said("walk.seed=7") ==
               "--set walk.seed=7: [walk] is not a section of a scene, which has container, balls, "
               "velocities, run, output");
    BOOST_TEST(said("run.sead=7") ==
               "--set run.sead=7: sead is not a key of [run], which takes seed, equilibrate, "
               "collisions_per_ball, time, collisions, method, precision");
    BOOST_TEST(said("seed=7") == "--set seed=7: seed is not a key of the scene, which takes title");
    BOOST_TEST(said("run.seed=") ==
               "--set run.seed=: has no value; write section.key=value on one line");
    BOOST_TEST(said("run.seed=7\ntitle=3") ==
               "--set run.seed=7?title=3: has no value; write section.key=value on one line");
    BOOST_TEST(said("run.seed=1 2") == "--set run.seed=1 2: the value is neither TOML nor a word; "
                                       "write a number, true, false, a word, or a list in [ ]");
    BOOST_TEST(said("balls.count=12x") ==
               "--set balls.count=12x: the value is neither TOML nor a word; "
               "write a number, true, false, a word, or a list in [ ]");
    BOOST_TEST(said("balls.count=many") == "count = \"many\": must be a whole number from 1 to "
                                           "134217727, written in digits only (--set "
                                           "balls.count=many)");
    BOOST_TEST(said("container.packing_fraction=0.75") ==
               "packing_fraction = 0.75: must lie in (0, 0.7405), close packing; lower it (--set "
               "container.packing_fraction=0.75)");
    BOOST_TEST(said("run.time=nan") ==
               "time = nan: must be a finite number, a time (--set run.time=nan)");
}

BOOST_AUTO_TEST_CASE(periodic_places_are_wrapped_and_others_keep_their_bits) {
    auto const text = changed(changed(four_balls, "walls", "periodic"),
                              "[[1, 1, 1], [3, 1, 1], [5, 1, 1], [7, 1, 1]]",
                              "[[-1, 1, 1], [-1e-20, 4, 4], [10, 25, 0.1], [9.9, -10.5, 3]]");
    auto const places = make_start(parse_scene(text, "scene.toml")).positions;
    BOOST_TEST((places.col(0) == Eigen::Vector3d(9, 1, 1)));
    BOOST_TEST((places.col(1) == Eigen::Vector3d(0, 4, 4)));
    BOOST_TEST((places.col(2) == Eigen::Vector3d(0, 5, 0.1)));
    BOOST_TEST((places.col(3) == Eigen::Vector3d(9.9, 9.5, 3)));
}

BOOST_AUTO_TEST_CASE(starts_from_a_file_are_checked) {
    auto const text = changed(
        changed(four_balls, "[[1, 1, 1], [3, 1, 1], [5, 1, 1], [7, 1, 1]]", "0"),
        "arrangement = \"explicit\"\npositions = 0", "arrangement = \"file\"\npath = \"start.h5\"");
    auto const reader = [](Eigen::Matrix3Xd const& places) {
        return [places](std::string const&) { return Start{places, 0 * places}; };
    };
    Eigen::Matrix3Xd places(3, 4);
    places << 1, 3, 5, 7, 1, 1, 1, 1, 1, 1, 1, 1;
    BOOST_TEST(start_message(text, reader(places)) == "");
    BOOST_TEST(beginning(start_message(text), "path = \"start.h5\": no trajectory") ==
               "path = \"start.h5\": no trajectory");
    std::string expected = "places of 3 balls where count = 4: they must agree";
    BOOST_TEST(beginning(start_message(text, reader(places.leftCols(3))), expected) == expected);
    places(2, 1) = std::nan("");
    expected = "ball 1 has z = nan: must be a finite number";
    BOOST_TEST(beginning(start_message(text, reader(places)), expected) == expected);
    places(2, 1) = 1;
    places(0, 1) = 1.5;
    expected = "balls 0 and 1 overlap by 0.5 diameters";
    BOOST_TEST(beginning(start_message(text, reader(places)), expected) == expected);
}

BOOST_AUTO_TEST_CASE(velocities_from_a_file_are_checked) {
    auto const text = changed(correct_scene, "\"maxwell\"", "\"file\"\npath = \"/a/start.h5\"");
    auto const reader = [](std::string const& path) {
        BOOST_TEST(path == "/a/start.h5");
        Eigen::Matrix3Xd velocities = Eigen::Matrix3Xd::Ones(3, 100);
        velocities(1, 42) = std::nan("");
        return Start{velocities, velocities};
    };
    std::string const expected = "ball 42 has vy = nan: must be a finite number";
    BOOST_TEST(beginning(start_message(text, reader), expected) == expected);
}

BOOST_AUTO_TEST_CASE(files_that_cannot_be_read_are_refused) {
    auto const folder = std::filesystem::temp_directory_path() / "clack_scene_errors";
    std::filesystem::create_directories(folder);
    auto const path = [&](std::string const& name) { return (folder / name).string(); };
    std::ofstream(path("empty.toml"));
    std::ofstream(path("blank.toml")) << " \n\n";
    std::ofstream(path("comment.toml")) << "# nothing\n";
    std::ofstream(path("good.toml")) << correct_scene;
    auto const said = [&](std::string const& name) {
        auto const message = message_of([&] { read_scene(path(name)); });
        return message.empty() ? "" : message.substr(message.find(": "));
    };
    BOOST_TEST(said("none.toml") == ": no such file; name a scene file (.toml)");
    BOOST_TEST(said("") == ": is a directory; name a scene file (.toml)");
    std::string const empty = ": is empty; a scene needs [container], [balls], [velocities] and ";
    BOOST_TEST(beginning(said("empty.toml"), empty) == empty);
    BOOST_TEST(beginning(said("blank.toml"), empty) == empty);
    BOOST_TEST(said("good.toml") == "");
    BOOST_TEST(beginning(message_of([&] { read_scene(path("comment.toml")); }),
                         "[balls] is miss") == "[balls] is miss");
    std::filesystem::remove_all(folder);
}
