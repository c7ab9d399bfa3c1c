#include "simulation/engine.hpp"
#include "state/errors.hpp"
#include "tests/made_up_balls.hpp"

#include <boost/test/unit_test.hpp>

#include <tuple>
#include <vector>

using namespace clack;

namespace {

auto says(std::string const& beginning) {
    return [beginning](LawBroken const& error) {
        BOOST_TEST_MESSAGE(error.what());
        return std::string(error.what()).starts_with(beginning);
    };
}

} // namespace

BOOST_AUTO_TEST_CASE(overlap_beyond_rounding_stops_the_run_and_names_the_pair) {
    System system;
    system.side = 10;
    system.count = 3;
    Start start;
    start.positions.resize(3, 3);
    start.velocities.resize(3, 3);
    start.positions << 2, 5, 5.9, 5, 5, 5, 5, 5, 5;
    start.velocities << 0, 0.5, -0.5, 0, 0, 0, 0, 0, 0;
    for (Method const method : {Method::table, Method::heap, Method::fast}) {
        auto const engine = make_engine(system, method, Precision::double_, start);
        BOOST_CHECK_EXCEPTION(engine->advance({.time = 1}), LawBroken,
                              says("balls 1 and 2 overlap by 0.095 diameters at t = 0"));
    }
}

BOOST_AUTO_TEST_CASE(overlap_that_recedes_is_left_alone) {
    System system;
    system.side = 10;
    system.count = 2;
    Start start;
    start.positions.resize(3, 2);
    start.velocities.resize(3, 2);
    start.positions << 5, 5.9, 5, 5, 5, 5;
    start.velocities << -1, 1, 0, 0, 0, 0;
    auto const engine = make_engine(system, Method::fast, Precision::double_, start);
    engine->advance({.time = 1});
    BOOST_TEST(engine->tallies().ball_collisions == 0u);
}

// They overlap by the rounding of the doubles that a start is given in.
BOOST_AUTO_TEST_CASE(touching_balls_of_a_start_may_collide_in_every_type) {
    System system;
    system.side = 10;
    system.count = 2;
    std::mt19937_64 random(8);
    for (Precision const precision :
         {Precision::single_, Precision::double_, Precision::extended, Precision::quadruple}) {
        for (int k = 0; k < 20; ++k) {
            Vector3<double> const aside = made_up::in_cube(random, -1, 1).normalized();
            Vector3<double> const middle = made_up::in_cube(random, 4, 6);
            Start start;
            start.positions.resize(3, 2);
            start.velocities.resize(3, 2);
            start.positions << middle - aside / 2, middle + aside / 2;
            start.velocities << aside, -aside;
            auto const engine = make_engine(system, Method::fast, precision, start);
            engine->advance({.time = 1});
            BOOST_TEST(engine->tallies().ball_collisions == 1u);
        }
    }
}

/// A touching close-packed lattice: there is no next moment.
BOOST_AUTO_TEST_CASE(jammed_balls_are_noticed) {
    System system = made_up::system(Boundary::periodic, 32, std::numbers::pi / std::sqrt(18));
    Start const start = made_up::lattice(system, 1);
    auto const engine = make_engine(system, Method::heap, Precision::double_, start);
    BOOST_CHECK_THROW(engine->advance({.ball_collisions = 10'000'000}), LawBroken);
}

BOOST_AUTO_TEST_CASE(resting_balls_never_collide_and_say_so) {
    System const system = made_up::system(Boundary::periodic, 32, 0.1);
    Start start = made_up::lattice(system, 1);
    start.velocities.setZero();
    for (Method const method : {Method::table, Method::heap, Method::fast}) {
        auto const engine = make_engine(system, method, Precision::double_, start);
        BOOST_TEST((engine->advance({.ball_collisions = 1}) == Stop::never));
        BOOST_TEST((engine->advance({.time = 1e6}) == Stop::time));
        BOOST_TEST(engine->time() == 1e6);
        // However far, without going through the epochs one by one.
        BOOST_TEST((engine->advance({.time = 1e37, .events = 2}) == Stop::time));
    }
}

BOOST_AUTO_TEST_CASE(goals_are_reached_exactly) {
    System const system = made_up::system(Boundary::walls, 32, 0.1);
    auto const engine =
        make_engine(system, Method::fast, Precision::double_, made_up::lattice(system, 1));
    BOOST_TEST((engine->advance({.time = 0.7}) == Stop::time));
    BOOST_TEST(engine->time() == 0.7);
    BOOST_TEST((engine->advance({.ball_collisions = 100}) == Stop::collisions));
    BOOST_TEST(engine->tallies().ball_collisions == 100u);
    BOOST_TEST((engine->advance({.events = 10}) == Stop::events));
    engine->start_clock();
    BOOST_TEST(engine->time() == 0);
    BOOST_TEST(engine->tallies().ball_collisions == 0u);
}

/// One ball a million times faster than the rest, a dense cluster in a wide box, a box of a million
/// diameters: no corner of the indexes is slow or wrong.
BOOST_AUTO_TEST_CASE(lopsided_scenes_go_the_same_way_by_every_method) {
    std::vector<std::tuple<System, Start, double>> scenes; // and until when
    System system = made_up::system(Boundary::walls, 108, 0.1);
    Start start = made_up::lattice(system, 4);
    start.velocities *= 1e-6;
    start.velocities.col(17) *= 1e12;
    scenes.emplace_back(system, start, 1e-3);
    System cluster = made_up::system(Boundary::periodic, 108, 0.5);
    start = made_up::lattice(cluster, 4);
    cluster.side *= 30;
    scenes.emplace_back(cluster, start, 100);
    System wide = made_up::system(Boundary::walls, 30, 0.1);
    start = made_up::lattice(wide, 4);
    start.positions *= 1e6 / wide.side;
    wide.side = 1e6;
    scenes.emplace_back(wide, start, 5e6);
    for (auto const& [box, begin, until] : scenes) {
        std::uint64_t wanted = 0;
        for (Method const method : {Method::table, Method::heap, Method::fast}) {
            auto const engine = make_engine(box, method, Precision::double_, begin);
            engine->hash_collisions();
            engine->advance({.time = until, .ball_collisions = 2000});
            Tallies const& tallies = engine->tallies();
            BOOST_TEST(tallies.ball_collisions + tallies.wall_collisions > 30u);
            if (wanted == 0) wanted = engine->hash();
            BOOST_TEST(engine->hash() == wanted);
        }
    }
}
