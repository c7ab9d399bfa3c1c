#include "neighbours/cell_grid.hpp"
#include "neighbours/every_pair.hpp"
#include "neighbours/neighbour_list.hpp"
#include "scheduling/binary_heap.hpp"
#include "scheduling/calendar.hpp"
#include "scheduling/collision_table.hpp"
#include "simulation/engine_of.hpp"
#include "simulation/epoch.hpp"
#include "tests/made_up_balls.hpp"
#include "validation/lattice_start.hpp"

#include <boost/test/unit_test.hpp>

using namespace clack;

namespace {

template <template <class> class Container> using State = BallState<double, Container<double>>;

template <template <class> class Container, template <class, class> class Search,
          template <class> class Queue>
std::unique_ptr<Engine> assemble(State<Container> state) {
    auto engine = std::make_unique<EngineOf<Simulation<double, Container, Search, Queue>>>(
        std::move(state), ModelDescription{});
    engine->hash_collisions();
    return engine;
}

template <template <class> class Container>
using Maker = std::unique_ptr<Engine> (*)(State<Container>);

/// Every search with every queue.
template <template <class> class Container>
std::vector<Maker<Container>> const makers{assemble<Container, EveryPair, CollisionTable>,
                                           assemble<Container, EveryPair, BinaryHeap>,
                                           assemble<Container, EveryPair, Calendar>,
                                           assemble<Container, CellGrid, CollisionTable>,
                                           assemble<Container, CellGrid, BinaryHeap>,
                                           assemble<Container, CellGrid, Calendar>,
                                           assemble<Container, NeighbourList, CollisionTable>,
                                           assemble<Container, NeighbourList, BinaryHeap>,
                                           assemble<Container, NeighbourList, Calendar>};

template <template <class> class Container> State<Container> fresh(System const& system) {
    return State<Container>(system, made_up::lattice(system, 2015), epoch_length(system, 1.7));
}

template <template <class> class Container>
void all_go_one_way(std::int64_t count, double packing_fraction, std::uint64_t collisions) {
    System const system = made_up::system(Container<double>::boundary, count, packing_fraction);
    std::uint64_t wanted = 0;
    for (auto const make : makers<Container>) {
        auto const engine = make(fresh<Container>(system));
        engine->advance({.ball_collisions = collisions});
        if (wanted == 0) wanted = engine->hash();
        BOOST_TEST(engine->hash() == wanted);
        BOOST_TEST(engine->tallies().ball_collisions == collisions);
    }
}

/// So many that all an event reads is asked for in advance, at places and in cells that are
/// foretold: what another collision changes in between must not matter.
template <template <class> class Container> void many_go_one_way() {
    System const system = made_up::system(Container<double>::boundary, 50'000, 0.2);
    std::uint64_t wanted = 0;
    for (auto const make :
         {assemble<Container, CellGrid, BinaryHeap>, assemble<Container, CellGrid, Calendar>,
          assemble<Container, NeighbourList, Calendar>}) {
        auto const engine = make(fresh<Container>(system));
        engine->advance({.ball_collisions = 20'000});
        if (wanted == 0) wanted = engine->hash();
        BOOST_TEST(engine->hash() == wanted);
    }
}

} // namespace

// Hundreds of collisions a ball: dozens of times past where rounding would have told two ways
// apart.
BOOST_AUTO_TEST_CASE(every_search_and_queue_goes_the_same_way_between_walls) {
    all_go_one_way<WalledCube>(108, 0.01, 4000);
    all_go_one_way<WalledCube>(60, 0.3, 8000);
}

BOOST_AUTO_TEST_CASE(every_search_and_queue_goes_the_same_way_in_a_periodic_cube) {
    all_go_one_way<PeriodicCube>(108, 0.01, 4000);
    all_go_one_way<PeriodicCube>(150, 0.3, 8000);
    all_go_one_way<PeriodicCube>(256, 0.55, 8000);
}

/// Balls that start on a lattice come to be exactly half a side apart, where either of two images
/// is the nearest; below 4.1 diameters all images count.
BOOST_AUTO_TEST_CASE(few_balls_of_a_lattice_go_the_same_way_in_narrow_cubes) {
    for (auto const& [count, packing_fraction] :
         {std::pair{2, 0.01}, {4, 0.01}, {16, 0.05}, {3, 0.05}, {6, 0.05}}) {
        System const system = made_up::system(Boundary::periodic, count, packing_fraction);
        for (unsigned seed = 1; seed <= 6; ++seed) {
            Start const start = validation::lattice_start(system, seed);
            std::uint64_t wanted = 0;
            for (Method const method : {Method::table, Method::heap, Method::fast}) {
                auto const engine = make_engine(system, method, Precision::double_, start);
                engine->hash_collisions();
                engine->advance({.ball_collisions = 1000});
                if (wanted == 0) wanted = engine->hash();
                BOOST_TEST(engine->hash() == wanted);
            }
        }
    }
}

/// Epochs, memory order and all: enough balls that they are moved about in memory.
BOOST_AUTO_TEST_CASE(balls_that_move_in_memory_leave_no_trace) {
    System const system = made_up::system(Boundary::periodic, 9000, 0.2);
    std::uint64_t wanted = 0;
    for (auto const make : {assemble<PeriodicCube, CellGrid, BinaryHeap>,
                            assemble<PeriodicCube, NeighbourList, Calendar>}) {
        auto state = fresh<PeriodicCube>(system);
        state.clock.length = 0x1p-4; // many epochs in a short run
        auto const engine = make(std::move(state));
        engine->advance({.time = 1.5});
        if (wanted == 0) wanted = engine->hash();
        BOOST_TEST(engine->hash() == wanted);
        BOOST_TEST(engine->tallies().ball_collisions > 10000u);
    }
}

BOOST_AUTO_TEST_CASE(many_balls_that_are_looked_ahead_for_go_one_way) {
    many_go_one_way<PeriodicCube>();
    many_go_one_way<WalledCube>();
}

BOOST_AUTO_TEST_CASE(clock_that_starts_late_gives_the_same_bits) {
    System const system = made_up::system(Boundary::walls, 108, 0.2);
    std::uint64_t wanted = 0;
    double overlap = 0;
    for (std::int64_t const epoch :
         {std::int64_t{0}, std::int64_t{1} << 30, std::int64_t{1} << 50}) {
        auto state = fresh<WalledCube>(system);
        state.clock.epoch = epoch;
        auto const engine = assemble<WalledCube, CellGrid, Calendar>(std::move(state));
        engine->advance({.ball_collisions = 10000});
        if (wanted == 0) {
            wanted = engine->hash();
            overlap = engine->tallies().deepest_overlap;
        }
        BOOST_TEST(engine->hash() == wanted);
        BOOST_TEST(engine->tallies().deepest_overlap == overlap);
    }
}

/// However the way is cut into calls and checkpoints, and whatever method goes on.
BOOST_AUTO_TEST_CASE(run_that_is_stopped_and_resumed_gives_the_same_bits) {
    for (Boundary const boundary : {Boundary::walls, Boundary::periodic}) {
        for (Precision const precision :
             {Precision::single_, Precision::double_, Precision::extended, Precision::quadruple}) {
            System const system = made_up::system(boundary, 108, 0.15);
            Start const start = made_up::lattice(system, 3);
            auto const whole = make_engine(system, Method::heap, precision, start);
            whole->hash_collisions();
            std::uint64_t const collisions = precision == Precision::quadruple ? 600 : 3000;
            whole->advance({.ball_collisions = collisions});

            auto engine = make_engine(system, Method::fast, precision, start);
            engine->hash_collisions();
            std::mt19937_64 random(1);
            Method const methods[] = {Method::table, Method::heap, Method::fast};
            while (engine->tallies().ball_collisions < collisions) {
                if (random() % 2 == 0)
                    engine->advance({.time = engine->time() + made_up::uniform(random, 0, 2),
                                     .ball_collisions = collisions});
                else
                    engine->advance({.ball_collisions = collisions, .events = random() % 500});
                engine =
                    make_engine(system, methods[random() % 3], precision, engine->checkpoint());
            }
            BOOST_TEST(engine->hash() == whole->hash());
            BOOST_TEST(engine->kinetic_energy() == whole->kinetic_energy());
        }
    }
}

/// An observer and a hash are listeners, not players.
BOOST_AUTO_TEST_CASE(watched_run_goes_the_same_way) {
    struct Counter : CollisionObserver {
        std::uint64_t seen = 0;
        double last = 0;
        void operator()(Collision<double> const& collision) override {
            ++seen;
            BOOST_TEST_REQUIRE(collision.time >= last);
            last = collision.time;
        }
    } counter;
    System const system = made_up::system(Boundary::walls, 64, 0.2);
    Start const start = made_up::lattice(system, 3);
    auto const alone = make_engine(system, Method::fast, Precision::double_, start);
    auto const watched = make_engine(system, Method::fast, Precision::double_, start);
    alone->advance({.ball_collisions = 3000});
    watched->advance({.ball_collisions = 3000}, &counter);
    BOOST_TEST(alone->time() == watched->time());
    BOOST_TEST((alone->snapshot().positions == watched->snapshot().positions));
    BOOST_TEST(counter.seen ==
               watched->tallies().ball_collisions + watched->tallies().wall_collisions);
}

/// One flipped last bit anywhere changes the hash: the test above could fail.
BOOST_AUTO_TEST_CASE(hash_notices_the_last_bit_of_one_velocity) {
    System const system = made_up::system(Boundary::walls, 64, 0.2);
    Start start = made_up::lattice(system, 3);
    std::uint64_t hashes[2];
    for (auto& hash : hashes) {
        auto const engine = make_engine(system, Method::fast, Precision::double_, start);
        engine->hash_collisions();
        engine->advance({.ball_collisions = 300});
        hash = engine->hash();
        start.velocities(1, 40) = std::nextafter(start.velocities(1, 40), 2);
    }
    BOOST_TEST(hashes[0] != hashes[1]);
}
