// Scenes at which an engine made for a gas that fills its cube could go wrong, slow down or swell.

#include "tests/made_up_balls.hpp"
#include "validation/timing.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace clack;

namespace {

struct Scene {
    System system;
    Start start;
};

Scene without_balls(Boundary const boundary, std::int64_t const count, double const side) {
    Scene scene;
    scene.system.boundary = boundary;
    scene.system.count = count;
    scene.system.side = side;
    scene.start.positions.resize(3, count);
    scene.start.velocities.resize(3, count);
    return scene;
}

void move_at_random(Scene& scene) {
    std::mt19937_64 random(2015);
    for (std::int64_t k = 0; k < scene.system.count; ++k)
        scene.start.velocities.col(k) = made_up::in_cube(random, -1.75, 1.75);
}

/// Sites along the side of a square (2) or cube (3) that has room for all.
std::int64_t sites_across(std::int64_t const count, int const dimensions) {
    double const root = std::pow(static_cast<double>(count), 1.0 / dimensions);
    return static_cast<std::int64_t>(std::ceil(root - 1e-9));
}

/// Balls on a simple cubic lattice from `corner` on.
void put_on_lattice(Scene& scene, double const corner, double const spacing) {
    std::int64_t const across = sites_across(scene.system.count, 3);
    for (std::int64_t k = 0; k < scene.system.count; ++k) {
        Eigen::Vector3d const site(static_cast<double>(k % across),
                                   static_cast<double>(k / across % across),
                                   static_cast<double>(k / across / across));
        scene.start.positions.col(k) = Eigen::Vector3d::Constant(corner) + spacing * site;
    }
}

/// What the others are compared with.
Scene ordinary(Boundary const boundary, std::int64_t const count) {
    System const system = made_up::system(boundary, count, 0.2);
    return {system, made_up::lattice(system, 2015)};
}

/// A dense lump in the middle of a cube fifty times as wide.
Scene lump(Boundary const boundary, std::int64_t const count) {
    constexpr double spacing = 1.05; // diameters
    double const width = spacing * static_cast<double>(sites_across(count, 3));
    Scene scene = without_balls(boundary, count, 50 * width);
    put_on_lattice(scene, 24.5 * width, spacing);
    move_at_random(scene);
    return scene;
}

/// A layer that touches one wall and flies into it, all at once, in a cube that is else empty.
Scene layer_at_wall(Boundary, std::int64_t const count) {
    constexpr double spacing = 1.2; // diameters
    std::int64_t const across = sites_across(count, 2);
    Scene scene = without_balls(Boundary::walls, count, spacing * static_cast<double>(across) + 1);
    move_at_random(scene);
    for (std::int64_t k = 0; k < count; ++k) {
        scene.start.positions.col(k) << 0.5, 0.6 + spacing * static_cast<double>(k % across),
            0.6 + spacing * static_cast<double>(k / across);
        scene.start.velocities(0, k) = -std::abs(scene.start.velocities(0, k));
    }
    return scene;
}

/// A gas in which one ball is a million times as fast as the others.
Scene one_fast_ball(Boundary const boundary, std::int64_t const count) {
    Scene scene = ordinary(boundary, count);
    scene.start.velocities.col(count / 2) *= 1e6;
    return scene;
}

/// Pairs that fly at each other in a cube a million diameters wide.
Scene wide_cube(Boundary const boundary, std::int64_t const count) {
    Scene scene = without_balls(boundary, count, 1e6);
    std::mt19937_64 random(2015);
    for (std::int64_t k = 0; k + 1 < count; k += 2) {
        Eigen::Vector3d const meeting = made_up::in_cube(random, 1e5, 9e5);
        Eigen::Vector3d const way = made_up::in_cube(random, -4e4, 4e4);
        Eigen::Vector3d const aside = made_up::in_cube(random, -0.25, 0.25);
        for (int const end : {0, 1}) {
            double const sign = end == 0 ? -1 : 1;
            scene.start.positions.col(k + end) = meeting + sign * (way + aside);
            scene.start.velocities.col(k + end) = -sign * way;
        }
    }
    return scene;
}

/// A periodic cube so small that a ball meets another through more than one image.
Scene tight_cube(Boundary, std::int64_t const count) {
    constexpr double spacing = 1.2; // diameters
    Scene scene = without_balls(Boundary::periodic, count,
                                spacing * static_cast<double>(sites_across(count, 3)));
    put_on_lattice(scene, 0, spacing);
    move_at_random(scene);
    return scene;
}

/// A lump that flies apart in a cube so wide that its balls are alone soon.
Scene cloud(Boundary const boundary, std::int64_t const count) {
    constexpr double spacing = 1.05, side = 1e9; // diameters
    Scene scene = without_balls(boundary, count, side);
    put_on_lattice(scene, side / 2, spacing);
    move_at_random(scene);
    return scene;
}

/// A ball that sends a pulse to and fro along a line of balls, which hardly move otherwise.
Scene pulse(Boundary const boundary, std::int64_t const count) {
    constexpr double spacing = 1.9; // diameters
    Scene scene = without_balls(boundary, count, spacing * static_cast<double>(count) + 1);
    std::mt19937_64 random(2015);
    for (std::int64_t k = 0; k < count; ++k) {
        scene.start.positions.col(k) << 1 + spacing * static_cast<double>(k), 15, 15;
        scene.start.velocities.col(k) << made_up::uniform(random, -1e-9, 1e-9), 0, 0;
    }
    scene.start.velocities(0, 0) = 1;
    return scene;
}

using Make = Scene (*)(Boundary boundary, std::int64_t count);
struct Kind {
    char const* name;
    Make make;
    std::int64_t few, many;     // balls; `many` is what is ordinary for such a scene
    double collisions_per_ball; // where all methods go the same way
};

Kind const kinds[] = {{"lump", lump, 125, 4000, 20},
                      {"layer at a wall", layer_at_wall, 121, 4000, 20},
                      {"one fast ball", one_fast_ball, 108, 4000, 40},
                      {"wide cube", wide_cube, 100, 100, 3},
                      {"tight cube", tight_cube, 7, 27, 200},
                      {"cloud", cloud, 125, 4000, 3},
                      {"pulse", pulse, 40, 4000, 1000}};

/// A kind of scene in the containers that it is made for.
std::vector<Scene> in_both(Make const make, std::int64_t const count) {
    std::vector<Scene> scenes;
    for (Boundary const boundary : {Boundary::walls, Boundary::periodic})
        if (Scene const scene = make(boundary, count); scene.system.boundary == boundary)
            scenes.push_back(scene);
    return scenes;
}

std::unique_ptr<Engine> engine_of(Scene const& scene, Method const method) {
    return make_engine(scene.system, method, Precision::double_, scene.start);
}

/// A ball has so many collisions, or flies long enough to cross its cube a dozen times.
Goal goal_of(Scene const& scene, double const collisions_per_ball) {
    double const speed = scene.start.velocities.colwise().norm().mean();
    return {.time = 12 * scene.system.side / speed,
            .ball_collisions = static_cast<std::uint64_t>(
                collisions_per_ball * static_cast<double>(scene.system.count) / 2)};
}

std::size_t bytes_after_a_while(Scene const& scene) {
    auto const engine = engine_of(scene, Method::fast);
    engine->advance(goal_of(scene, 1));
    return engine->bytes();
}

/// Processor time of the start and the first collisions, a ball; the least of several.  [s]
double seconds_per_ball(Scene const& scene) {
    double least = std::numeric_limits<double>::infinity();
    for (int attempt = 0; attempt < 3; ++attempt) {
        double const begin = validation::processor_seconds();
        engine_of(scene, Method::fast)->advance(goal_of(scene, 1));
        least = std::min(least, validation::processor_seconds() - begin);
    }
    return least / static_cast<double>(scene.system.count);
}

} // namespace

BOOST_AUTO_TEST_CASE(all_methods_go_the_same_way) {
    for (Kind const& kind : kinds) {
        for (Scene const& scene : in_both(kind.make, kind.few)) {
            std::uint64_t wanted = 0;
            for (Method const method : {Method::table, Method::heap, Method::fast}) {
                auto const engine = engine_of(scene, method);
                engine->hash_collisions();
                engine->advance(goal_of(scene, kind.collisions_per_ball));
                if (method == Method::table) wanted = engine->hash();
                BOOST_TEST_CONTEXT(kind.name << ", " << engine->model().boundary) {
                    BOOST_TEST(engine->hash() == wanted);
                    BOOST_TEST(2 * engine->tallies().ball_collisions >=
                               static_cast<std::uint64_t>(kind.few - 1));
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(memory_is_at_most_twice_the_ordinary) {
    for (Kind const& kind : kinds) {
        for (Scene const& scene : in_both(kind.make, kind.many)) {
            std::size_t const usual =
                bytes_after_a_while(ordinary(scene.system.boundary, kind.many));
            BOOST_TEST_CONTEXT(kind.name)
            BOOST_TEST(bytes_after_a_while(scene) <= 2 * usual);
        }
    }
}

/// Among eight times as many balls a ball should cost the same; one that is tried against all
/// others costs eight times as much. Three leaves room for the caches on one side and for what does
/// not grow on the other.
BOOST_AUTO_TEST_CASE(cost_of_a_ball_does_not_grow_with_their_number) {
    for (Make const make : {lump, layer_at_wall, one_fast_ball}) {
        std::vector<Scene> const few = in_both(make, 500), many = in_both(make, 4000);
        for (std::size_t k = 0; k < few.size(); ++k)
            BOOST_TEST(seconds_per_ball(many[k]) < 3 * seconds_per_ball(few[k]));
    }
}

BOOST_AUTO_TEST_CASE(memory_stays_where_a_few_balls_move_and_the_others_wait) {
    auto const engine = engine_of(pulse(Boundary::walls, 400), Method::fast);
    engine->advance({.ball_collisions = 100'000});
    auto const usual = bytes_after_a_while(ordinary(Boundary::walls, 400));
    BOOST_TEST(engine->bytes() <= 2 * usual);
}

// Nothing is made for where the balls were: neither buckets of time nor cells.
BOOST_AUTO_TEST_CASE(balls_that_have_flown_apart_take_hardly_longer_than_with_the_table) {
    for (Boundary const boundary : {Boundary::walls, Boundary::periodic}) {
        Scene const scene = cloud(boundary, 343);
        auto const seconds = [&](Method const method) {
            double const begin = validation::processor_seconds();
            engine_of(scene, method)->advance({.time = 3 * scene.system.side});
            return validation::processor_seconds() - begin;
        };
        BOOST_TEST(seconds(Method::fast) < 12 * seconds(Method::table));
    }
}
