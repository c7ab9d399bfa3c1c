// What instruction_count_smoke_test.sh counts the instructions of: a few collisions of one of three
// small scenes.
//
//   instruction_count             names the scenes
//   instruction_count --version   names the compiler
//   instruction_count SCENE       moves its balls and prints how many collisions `counted` made

#include "simulation/build_engine.hpp"
#include "validation/lattice_start.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string_view>

namespace {

using namespace clack;

struct CountedScene {
    char const* name;
    Boundary boundary;
    double packing_fraction;
};

/// Cells, lists, and the walls that both of them may have.
constexpr CountedScene scenes[] = {{"periodic_0.05", Boundary::periodic, 0.05},
                                   {"periodic_0.40", Boundary::periodic, 0.40},
                                   {"walls_0.20", Boundary::walls, 0.20}};

constexpr std::int64_t count = 1'000;           // balls
constexpr std::uint64_t equilibration = 10'000; // ball-ball collisions, to leave the lattice
constexpr std::uint64_t collisions = 40'000;    // ball-ball collisions, more than an epoch holds

} // namespace

/// The event loop and nothing else: callgrind knows it by its name and counts as long as it lasts.
extern "C" [[gnu::noipa]] void counted(clack::Engine& engine) {
    engine.advance({.ball_collisions = equilibration + collisions});
}

namespace {

void run(CountedScene const& scene) {
    System system;
    system.boundary = scene.boundary;
    system.count = count;
    system.side = std::cbrt(count * std::numbers::pi / (6 * scene.packing_fraction));
    Start const start = validation::lattice_start(system, 2015);
    auto const engine = build_engine<double>(system, Method::fast, Precision::double_,
                                             {.start = &start, .checkpoint = nullptr});
    engine->advance({.ball_collisions = equilibration});
    counted(*engine);
    std::printf("%llu\n", static_cast<unsigned long long>(collisions));
}

} // namespace

int main(int argc, char** argv) {
    std::string_view const wanted = argc > 1 ? argv[1] : "";
    if (wanted == "--version") std::puts("g++ " __VERSION__);
    for (CountedScene const& scene : scenes) {
        if (wanted.empty()) std::puts(scene.name);
        if (wanted == scene.name) run(scene);
    }
}
