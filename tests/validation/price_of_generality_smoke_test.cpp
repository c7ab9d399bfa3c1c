// The experiment on the price of generality: ingredients do what they say, neutral ones leave no
// trace, and a bad choice of `auto` is caught.

#include "validation/price_of_generality.hpp"

#include "neighbours/every_pair.hpp"

#include <boost/test/unit_test.hpp>

#include <numeric>
#include <vector>

using namespace clack;
using namespace clack::validation;
using namespace clack::validation::price;

namespace {

System const small = cube(Boundary::walls, 100, 0.2);

/// Two balls that meet head on, between walls far away.
std::pair<Vector3<double>, Vector3<double>> head_on(auto&& collide) {
    Ball<double> i, j;
    i.velocity = {1, 0.5, 0};
    j.velocity = {-1, 0, 0.25};
    collide(i, j);
    return {i.velocity, j.velocity};
}

} // namespace

BOOST_AUTO_TEST_CASE(neutral_ingredients_leave_the_balls_their_way) {
    Start const start = equilibrated(small, 1);
    for (Ingredient const& ingredient : ingredients())
        BOOST_TEST(require_neutral(ingredient, small, start) >= 5, ingredient.name);
}

// Those who look pay for so many looks, whatever the slices that are timed.
BOOST_AUTO_TEST_CASE(balls_are_looked_at_once_for_each_collision_of_a_ball) {
    int looks = 0;
    TimedRun run = run_with<>(small, equilibrated(small, 1));
    run.look = [&](Engine const&) { ++looks; };
    run.go(450); // and a third before
    BOOST_TEST(run.engine->tallies().ball_collisions == 600);
    BOOST_TEST(looks == 2 * 600 / small.count);
}

BOOST_AUTO_TEST_CASE(ingredient_that_is_not_neutral_is_caught) {
    Start const start = equilibrated(small, 1);
    Ingredient const narrower{"narrower balls", [](System system, Start const& from) {
                                  system.diameter *= 1 - 1e-12;
                                  return run_with<>(system, from);
                              }};
    BOOST_CHECK_THROW(require_neutral(narrower, small, start), LawBroken);
}

BOOST_AUTO_TEST_CASE(heavier_ball_keeps_momentum_and_energy) {
    MassOfEach<double> const model(small);
    double const excess = 2;
    Vector3<double> given;
    auto const [vi, vj] = head_on([&](Ball<double>& i, Ball<double>& j) {
        i.note = excess;
        j.note = 0;
        given = model.collide(i.velocity, j.velocity, {1, 0, 0}, 0);
    });
    double const mass = 1 + excess;
    Vector3<double> const before{mass * 1 - 1, mass * 0.5, 0.25};
    BOOST_TEST((mass * vi + vj - before).norm() < 1e-15);
    BOOST_TEST(mass * vi.squaredNorm() + vj.squaredNorm() == mass * 1.25 + 1.0625,
               boost::test_tools::tolerance(1e-15));
    BOOST_TEST((given - Vector3<double>{vj[0] + 1, 0, 0}).norm() < 1e-15);
    BOOST_TEST(vj[0] > vi[0]);
}

// With diameters that differ, and not only what is neutral: cells, vectors and what decides ties go
// by them.
BOOST_AUTO_TEST_CASE(balls_of_two_sizes_meet_at_the_sum_of_their_radii) {
    System const system = cube(Boundary::periodic, 256, 0.3);
    Start const start = lattice_start(system, 1);
    BallState<double, PeriodicCube<double>> state(system, start, epoch_length(system, speed));
    auto const excess = [](std::int64_t ball) { return ball % 3 == 0 ? 0.0 : -0.2; };
    for (std::int32_t ball = 0; ball < state.count(); ++ball) state[ball].note = excess(ball);
    DiameterOfEach<double> const model(system);
    Scenery<double, PeriodicCube<double>, DiameterOfEach<double>> const scenery{
        state.balls, state.numbers, state.cube, model, false};
    std::vector<std::int32_t> everybody(state.balls.size()); // full lanes
    std::iota(everybody.begin(), everybody.end(), 0);
    for (std::int32_t const ball : everybody) {
        auto const at_once = earliest_contact(scenery, ball, everybody, 0.0);
        auto const one_by_one = earliest_one_by_one(scenery, ball, everybody, 0.0);
        BOOST_TEST(at_once.time == one_by_one.time);
        BOOST_TEST(at_once.ball == one_by_one.ball);
    }
    double const energy = state.kinetic_energy();
    Simulation<double, PeriodicCube, CellGrid, Calendar, DiameterOfEach> simulation(
        std::move(state));
    double off = 0;
    int of_both_sizes = 0;
    simulation.advance({.ball_collisions = 5'000}, [&](Collision<double> const& collision) {
        double const reach = 1 + excess(collision.first) + excess(collision.second);
        off = std::max(off, std::abs(collision.separation.norm() - reach));
        of_both_sizes += excess(collision.first) != excess(collision.second);
    });
    BOOST_TEST(off < 1e-13);
    BOOST_TEST(of_both_sizes > 1'000);
    BOOST_TEST(simulation.state().kinetic_energy() == energy, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(normal_velocity_comes_back_by_the_restitution) {
    Restitution<double> const model(small, 0.5);
    auto const [vi, vj] = head_on([&](Ball<double>& i, Ball<double>& j) {
        model.collide(i.velocity, j.velocity, {1, 0, 0}, 0);
    });
    BOOST_TEST(vj[0] - vi[0] == 0.5 * 2, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(vi[1] == 0.5);
}

BOOST_AUTO_TEST_CASE(wall_that_rises_is_met_where_the_ball_falls_on_it) {
    FallingBalls<double> const model(small);
    RisingCube<double> const walls(small, 2);
    Ball<double> ball;
    ball.point = {walls.high, walls.high, walls.low + 1}; // long on its way down along the others
    ball.time = 0.25;
    for (double const upwards : {-1.0, 0.0, 1.0, 5.0}) { // in the frame at rest; 1 is too slow
        ball.velocity = Vector3<double>::Constant(walls.pace(ball.time));
        ball.velocity[2] += upwards;
        auto const contact = model.wall_contact(ball, walls);
        BOOST_TEST(contact.wall == (upwards == 5 ? 5 : 4));
        int const towards = contact.wall == 5 ? 1 : -1;
        double const wait = contact.time - ball.time;
        BOOST_TEST(ball.point[2] + ball.velocity[2] * wait ==
                       model.plane(walls, towards, contact.time, ball.velocity[2]),
                   boost::test_tools::tolerance(1e-14));
    }
}

/// Balls that fall, seen after so many collisions.
template <template <class, class> class Search>
Snapshot fallen(System const& system, Start const& start, double const field) {
    Simulation<double, RisingCube, Search, Calendar, FallingBalls> simulation(
        BallState<double, RisingCube<double>>(system, start, epoch_length(system, speed), field));
    simulation.advance({.ball_collisions = 5'000}, NoObserver{});
    BOOST_TEST(simulation.state().clock.epoch > 3);
    BOOST_TEST(simulation.state().tallies.deepest_overlap < 1e-13);
    return simulation.state().snapshot();
}

// A field, and not only what is neutral: walls, records at a change of frame and cells go by it.
BOOST_AUTO_TEST_CASE(falling_balls_keep_their_energy_between_their_walls) {
    Start const start = equilibrated(small, 1);
    double const field = 1;
    auto const energy = [&](Eigen::Matrix3Xd const& places, Eigen::Matrix3Xd const& velocities) {
        return velocities.squaredNorm() / 2 + field * places.sum();
    };
    Snapshot const by_cells = fallen<CellGrid>(small, start, field);
    Snapshot const by_pairs = fallen<EveryPair>(small, start, field);
    BOOST_TEST((by_cells.positions == by_pairs.positions)); // to the last bit
    BOOST_TEST(energy(by_cells.positions, by_cells.velocities) ==
                   energy(start.positions, start.velocities),
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(by_cells.positions.minCoeff() > small.diameter / 2 - 1e-12);
    BOOST_TEST(by_cells.positions.maxCoeff() < small.side - small.diameter / 2 + 1e-12);
    BOOST_TEST(by_cells.positions.mean() < 0.45 * small.side); // they have sunk
}

// The mutant: `auto` that takes the table everywhere.
BOOST_AUTO_TEST_CASE(choice_that_is_slow_is_caught) {
    Point const many{Boundary::walls, 500, 0.2, 3, 5};
    MethodMaker const by_table = [](System const& system, Method const method, Start const& start) {
        return make_true_method(system, method == Method::automatic ? Method::table : method,
                                start);
    };
    std::vector<Measurement> slow, truly;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        slow.push_back(measure(many, seed, by_table));
        truly.push_back(measure(many, seed));
    }
    BOOST_TEST(slow.front()[0] == infinity<double>); // it is the table
    auto const verdict = [&](std::vector<Measurement> const& replicates) {
        Ledger ledger({{"boundary", ""}, {"count", ""}, {"packing_fraction", ""}});
        enter(ledger, many, replicates);
        ledger.judge(of_timing);
        return ledger.verdict("auto_over_heap");
    };
    BOOST_TEST((verdict(slow) == Verdict::differs));
    BOOST_TEST((verdict(truly) != Verdict::differs));
}

// Reasons and bounds of the choice: each kind of scene by its own model.
BOOST_AUTO_TEST_CASE(auto_goes_by_number_and_packing_fraction) {
    auto const chosen = [](Boundary boundary, std::int64_t count, double packing_fraction) {
        ModelDescription const model =
            make_true_method(cube(boundary, count, packing_fraction), Method::automatic,
                             lattice_start(cube(boundary, count, packing_fraction), 1))
                ->model();
        return model.search + " " + model.queue;
    };
    BOOST_TEST(chosen(Boundary::walls, 4, 0.05) == "EveryPair CollisionTable");
    BOOST_TEST(chosen(Boundary::walls, 30, 0.05) == "EveryPair Calendar");
    BOOST_TEST(chosen(Boundary::periodic, 20, 0.2) == "EveryPair BinaryHeap");
    BOOST_TEST(chosen(Boundary::walls, 500, 0.2) == "CellGrid Calendar");
    BOOST_TEST(chosen(Boundary::periodic, 500, 0.45) == "NeighbourList Calendar");
}
