#include "tests/cli/program.hpp"
#include "tests/io/python.hpp"

#include "io/trajectory_reader.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

using namespace clack;
using namespace clack::test;

namespace {

Folder const folder;

std::string scene(std::string const& boundary, std::string const& goal) {
    return folder.write("scene.toml", "title = \"a test\"\n[container]\nboundary = \"" + boundary +
                                          "\"\nside = 8.0\n[balls]\ncount = 108\narrangement = "
                                          "\"fcc\"\n[velocities]\ndistribution = \"maxwell\"\n"
                                          "temperature = 2.0\n[run]\nseed = 3\n" +
                                          goal +
                                          "\n[output]\nframe_interval = 0.25\nevents = true\n");
}

nlohmann::json run_json(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--quiet", "--json"});
    auto const outcome = run_clack(arguments);
    BOOST_REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
    BOOST_TEST(outcome.err.empty());
    return nlohmann::json::parse(outcome.out);
}

} // namespace

BOOST_AUTO_TEST_CASE(summary_has_every_key) {
    for (std::string const boundary : {"walls", "periodic"}) {
        auto const result = run_json({"run", scene(boundary, "time = 20"), "-o", "out.h5"});
        BOOST_TEST(result.at("time") == 20);
        BOOST_TEST(result.at("ball_collisions") > 1000);
        BOOST_TEST((result.at("wall_collisions") > 0) == (boundary == "walls"));
        BOOST_TEST(result.at("cpu_seconds") > 0);
        BOOST_TEST(result.at("collisions_per_cpu_second") > 0);
        BOOST_TEST(result.at("bytes_per_ball") > 64);
        BOOST_TEST(result.at("method") == "auto");
        BOOST_TEST(result.at("precision") == "double");
        BOOST_TEST(std::abs(result.at("temperature").get<double>() - 2) < 1e-13);
        BOOST_TEST(std::abs(result.at("energy_drift").get<double>()) < 1e-13);
        BOOST_TEST(result.at("deepest_overlap") < 1e-12);
        BOOST_TEST(result.at("hash").get<std::string>().size() == 16u);
        BOOST_TEST(result.at("horizon").at("error") == 0.01);
        BOOST_TEST(result.at("horizon").at("collisions_per_ball") > 5);
        BOOST_TEST(result.at("horizon").at("time") > 0);
        BOOST_TEST(result.at("seed") == 3);
        BOOST_TEST(result.at("version") == own_provenance().version);
        auto const& factor = result.at("compressibility_factor");
        BOOST_TEST(factor.at("virial").at("value") > 1);
        BOOST_TEST(factor.at("virial").at("error") > 0);
        BOOST_TEST(factor.contains("wall") == (boundary == "walls"));
        BOOST_TEST(result.at("wall_pressure").is_null() == (boundary == "periodic"));
        if (boundary == "periodic") continue;
        // Two routes to one number: they agree within five of their standard errors.
        double const difference =
            factor["virial"]["value"].get<double>() - factor["wall"]["value"].get<double>();
        double const error = std::hypot(factor["virial"]["error"].get<double>(),
                                        factor["wall"]["error"].get<double>());
        BOOST_TEST(std::abs(difference) < 5 * error);
    }
}

BOOST_AUTO_TEST_CASE(run_says_what_it_found_in_words) {
    auto const outcome =
        run_clack({"run", scene("walls", "collisions_per_ball = 50"), "--hash", "--quiet"});
    BOOST_TEST(outcome.code == 0);
    BOOST_TEST(outcome.err.empty());
    for (std::string const word : {"collisions per CPU second", "Z by the virial", "Z by the walls",
                                   "energy drift", "deepest overlap", "horizon", "hash"}) {
        BOOST_TEST(outcome.out.find(word) != std::string::npos, word);
    }
    BOOST_TEST(std::filesystem::exists("scene.h5")); // the scene's stem, in the current folder
}

BOOST_AUTO_TEST_CASE(run_stops_exactly_where_it_is_told) {
    auto const path = scene("periodic", "collisions = 1234");
    BOOST_TEST(run_json({"run", path, "-o", "out.h5"}).at("ball_collisions") == 1234);
    BOOST_TEST(run_json({"run", path, "-o", "out.h5", "--set", "run.collisions_per_ball=10"})
                   .at("ball_collisions") == 540);
    auto const still = run_json({"run", path, "-o", "out.h5", "--set", "run.time=0"});
    BOOST_TEST(still.at("time") == 0);
    BOOST_TEST(still.at("compressibility_factor").at("virial").is_null());
    BOOST_TEST(TrajectoryReader("out.h5").frame_count() == 1u);
}

BOOST_AUTO_TEST_CASE(frames_are_where_they_should_be) {
    run_json({"run", scene("walls", "time = 1.1"), "-o", "out.h5"});
    TrajectoryReader const file("out.h5");
    BOOST_REQUIRE_EQUAL(file.frame_count(), 6u);
    for (std::size_t k = 0; k < 5; ++k) {
        BOOST_TEST(file.frame_time(k) == 0.25 * static_cast<double>(k));
    }
    BOOST_TEST(file.frame_time(5) == 1.1);
    BOOST_TEST(file.event_count() > 100u);
}

BOOST_AUTO_TEST_CASE(check_passes_a_true_file_and_names_what_is_wrong_in_another) {
    run_json({"run", scene("walls", "time = 3"), "-o", "out.h5"});
    auto const good = run_clack({"check", "out.h5"});
    BOOST_TEST(good.code == 0, good.out);
    BOOST_TEST(good.out.find("all laws hold") != std::string::npos);
    {
        hdf5::Id const file(H5Fopen("out.h5", H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
        auto const places = hdf5::open_dataset(file, "particles/balls/position/value");
        std::vector<double> numbers(13 * 108 * 3);
        H5Dread(places.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
        numbers[(5 * 108 + 17) * 3 + 1] += 1e-6; // ball 17 of frame 5
        H5Dwrite(places.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    }
    auto const bad = run_clack({"check", "out.h5"});
    BOOST_TEST(bad.code == 1);
    BOOST_TEST(bad.out.find("BROKEN  events lead from frame to frame") != std::string::npos);
    BOOST_TEST(bad.out.find("ball 17 at t = 1.25") != std::string::npos, bad.out);
}

BOOST_AUTO_TEST_CASE(info_tells_of_scenes_and_of_files) {
    auto const path = scene("walls", "collisions_per_ball = 5");
    auto const of_scene = run_clack({"info", path});
    BOOST_TEST(of_scene.code == 0);
    for (std::string const word : {"a test", "packing fraction", "model", "memory", "duration"}) {
        BOOST_TEST(of_scene.out.find(word) != std::string::npos, word);
    }
    BOOST_TEST(of_scene.out.find("about less than") == std::string::npos);
    run_json({"run", path, "-o", "out.h5"});
    auto const of_file = run_clack({"info", "out.h5"});
    BOOST_TEST(of_file.code == 0);
    for (std::string const word : {"frames", "events", "finished", "seed", "compiled with"}) {
        BOOST_TEST(of_file.out.find(word) != std::string::npos, word);
    }
}

BOOST_AUTO_TEST_CASE(export_writes_every_frame) {
    run_json({"run", scene("periodic", "time = 1"), "-o", "out.h5"});
    BOOST_TEST(run_clack({"export", "out.h5"}).code == 0);
    auto const text = text_of("out.xyz");
    BOOST_TEST(std::count(text.begin(), text.end(), '\n') == 5 * (108 + 2));
    BOOST_TEST(run_clack({"export", "out.h5", "-o", "-"}).out == text);
}

BOOST_AUTO_TEST_CASE(a_run_can_start_from_the_last_frame_of_another) {
    run_json({"run", scene("periodic", "time = 1"), "-o", "first.h5"});
    auto const path = folder.write("second.toml", R"(
[container]
boundary = "periodic"
side = 8.0
[balls]
count = 108
arrangement = "file"
path = "first.h5"
[velocities]
distribution = "file"
[run]
time = 0
)");
    run_json({"run", path, "-o", "second.h5"});
    auto const end = TrajectoryReader("first.h5").snapshot(4);
    auto const begin = TrajectoryReader("second.h5").snapshot(0);
    BOOST_TEST((end.positions == begin.positions));
    BOOST_TEST((end.velocities == begin.velocities));
}

BOOST_AUTO_TEST_CASE(mdanalysis_and_h5py_see_the_frames_of_a_real_run) {
    BOOST_REQUIRE(!python().empty());
    run_json({"run", scene("periodic", "time = 2"), "-o", "out.h5"});
    run_clack({"export", "out.h5", "-o", "out.xyz"});
    auto const command = python() + " " CLACK_SOURCE_DIR "/tests/cli/compare_readers.py out.h5 "
                                    "out.xyz 2>readers.log";
    BOOST_TEST(std::system(command.c_str()) == 0, text_of("readers.log"));
}

BOOST_AUTO_TEST_CASE(help_and_version_are_there) {
    BOOST_TEST(run_clack({"--version"}).out.find("clack ") == 0u);
    for (std::string const command : {"run", "resume", "info", "check", "export"}) {
        auto const outcome = run_clack({command, "--help"});
        BOOST_TEST(outcome.code == 0);
        BOOST_TEST(outcome.out.find("Usage: clack " + command) != std::string::npos, outcome.out);
    }
    BOOST_TEST(run_clack({"--help"}).out.find("Exit codes") != std::string::npos);
}
