#include "scenes/scene.hpp"
#include "simulation/engine.hpp"

#include <boost/test/unit_test.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <string>

using namespace clack;

namespace {

/// Of the first collisions of each scene that ships: the same on every machine, by every compiler,
/// at every optimisation. A new value here means that clack moves balls differently.
std::map<std::string, std::uint64_t> const golden{
    {"crystal", 0x9eff6118e4b9469d},     {"dense_fluid", 0xdb33c0034e5171a4},
    {"dilute", 0xb9e1c3d37c5b1c66},      {"gas", 0xa94ecc6918960fe8},
    {"hot_ball", 0x051036bf6849a4be},    {"newtons_cradle", 0xc2e098dea8acce1e},
    {"report_grid", 0x35d68f649199210e}, {"two_balls", 0xdf3903ca5aea0eca},
};

std::uint64_t hash_of(Scene const& scene, Method method) {
    auto const engine = make_engine(scene.system, method, scene.precision, make_start(scene));
    engine->hash_collisions();
    engine->advance({.time = 1000, .ball_collisions = 3000});
    return engine->hash();
}

} // namespace

BOOST_AUTO_TEST_CASE(scenes_that_ship_have_their_hash) {
    std::size_t seen = 0;
    for (auto const& entry :
         std::filesystem::directory_iterator(CLACK_SOURCE_DIR "/validation/scenes")) {
        std::string const name = entry.path().stem();
        Scene const scene = read_scene(entry.path());
        std::uint64_t const hash = hash_of(scene, scene.method);
        BOOST_TEST_CONTEXT(fmt::format("{{\"{}\", 0x{:016x}}}", name, hash)) {
            BOOST_TEST_REQUIRE(golden.count(name) == 1u);
            BOOST_TEST(golden.at(name) == hash);
            BOOST_TEST(hash_of(scene, Method::heap) == hash);
        }
        ++seen;
    }
    BOOST_TEST(seen == golden.size());
}
