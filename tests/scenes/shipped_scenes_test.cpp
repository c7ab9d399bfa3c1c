#include "tests/scenes/scene_text.hpp"

#include <filesystem>
#include <fstream>

using namespace clack;

namespace {

std::vector<std::string> shipped_scenes() {
    std::vector<std::string> paths;
    for (auto const& entry :
         std::filesystem::directory_iterator(CLACK_SOURCE_DIR "/validation/scenes"))
        if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

} // namespace

BOOST_AUTO_TEST_CASE(every_shipped_scene_starts) {
    auto const paths = shipped_scenes();
    BOOST_TEST(paths.size() >= 8u);
    for (auto const& path : paths) {
        Scene const scene = read_scene(path);
        Start const start = make_start(scene);
        BOOST_TEST(start.positions.cols() == scene.system.count, path);
        BOOST_TEST(start.velocities.cols() == scene.system.count, path);
        BOOST_TEST(!scene.title.empty(), path);
    }
}

BOOST_AUTO_TEST_CASE(every_shipped_scene_says_what_to_look_for) {
    for (auto const& path : shipped_scenes()) {
        std::ifstream file(path);
        std::string line;
        std::getline(file, line);
        BOOST_TEST(line.starts_with("# Look for: "), path);
    }
}
