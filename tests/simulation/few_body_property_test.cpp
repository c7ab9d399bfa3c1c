#include "reference/ghost_chain.hpp"
#include "reference/triangle_wave.hpp"
#include "simulation/engine.hpp"
#include "simulation/model_choice.hpp"
#include "tests/made_up_balls.hpp"

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

using namespace clack;
namespace data = boost::unit_test::data;

namespace clack { // for the names of the data-driven cases
std::ostream& operator<<(std::ostream& out, Precision precision) {
    return out << name_of(precision);
}
std::ostream& operator<<(std::ostream& out, Method method) { return out << name_of(method); }
} // namespace clack

namespace {

Precision const precisions[] = {Precision::single_, Precision::double_, Precision::extended,
                                Precision::quadruple};
Method const methods[] = {Method::table, Method::heap, Method::fast};

double roundoff(Precision precision) {
    switch (precision) {
    case Precision::single_:
        return 0x1p-24;
    case Precision::double_:
        return 0x1p-53;
    case Precision::extended:
        return 0x1p-53; // as snapshots show it
    default:
        return 0x1p-53;
    }
}

/// Balls on one line between two walls, along x.
struct Chain {
    System system;
    Start start;

    Chain(std::int64_t count, double side, std::uint64_t seed) {
        system.count = count;
        system.side = side;
        std::mt19937_64 random(seed);
        start.positions = Eigen::Matrix3Xd::Constant(3, count, side / 2);
        start.velocities = Eigen::Matrix3Xd::Zero(3, count);
        double const gap = side / static_cast<double>(count);
        for (std::int64_t k = 0; k < count; ++k) {
            // multiples of 2^-10, which every precision holds exactly
            double const place =
                gap * (static_cast<double>(k) + 0.5) + made_up::uniform(random, -0.2, 0.2);
            start.positions(0, k) = std::round(place * 1024) / 1024;
            start.velocities(0, k) = std::round(made_up::uniform(random, -1, 1) * 1024) / 1024;
        }
    }

    reference::GhostChain solution() const {
        std::vector<double> places, speeds;
        for (Eigen::Index k = 0; k < start.positions.cols(); ++k) {
            places.push_back(start.positions(0, k));
            speeds.push_back(start.velocities(0, k));
        }
        return {system.side, system.diameter, places, speeds};
    }
};

} // namespace

/// A chain is not chaotic, so rounding only adds up: a few units a collision over 10^4 collisions.
BOOST_DATA_TEST_CASE(chain_follows_its_ghosts, data::make(precisions) * data::make(methods),
                     precision, method) {
    Chain const chain(10, 20, 3);
    auto const engine = make_engine(chain.system, method, precision, chain.start);
    std::uint64_t const collisions = precision == Precision::quadruple ? 2000 : 10000;
    engine->advance({.ball_collisions = collisions});
    // Stop between two collisions, where the ghosts have not to be told apart.
    double const time = engine->time() + 0x1p-12;
    engine->advance({.time = time});
    auto const ghosts = chain.solution();
    auto const wanted = ghosts.positions(time);
    auto const shot = engine->snapshot();
    double const bound =
        64 * roundoff(precision) * chain.system.side * static_cast<double>(collisions);
    for (Eigen::Index k = 0; k < 10; ++k)
        BOOST_TEST(std::abs(shot.positions(0, k) - wanted[static_cast<std::size_t>(k)]) < bound);
    if (precision != Precision::single_) {
        BOOST_TEST(engine->tallies().ball_collisions ==
                   static_cast<std::uint64_t>(ghosts.ball_collisions(time)));
        BOOST_TEST(engine->tallies().wall_collisions ==
                   static_cast<std::uint64_t>(ghosts.wall_collisions(time)));
    }
    BOOST_TEST(shot.positions.row(1).isConstant(10));
}

BOOST_DATA_TEST_CASE(one_ball_follows_a_triangle_wave_along_each_axis, data::make(precisions),
                     precision) {
    System system;
    system.count = 1;
    system.side = 4.5;
    Start start;
    start.positions.resize(3, 1);
    start.velocities.resize(3, 1);
    start.positions << 1, 2.25, 3.5;
    start.velocities << 0.75, -1.25, 0.3125;
    auto const engine = make_engine(system, Method::automatic, precision, start);
    double const time = 1000.125;
    engine->advance({.time = time});
    auto const shot = engine->snapshot();
    std::int64_t hits = 0;
    for (int d = 0; d < 3; ++d) {
        reference::TriangleWave const wave(system.accessible_side(), start.positions(d, 0) - 0.5,
                                           start.velocities(d, 0));
        double const bound = 4000 * roundoff(precision) * system.side;
        BOOST_TEST(std::abs(shot.positions(d, 0) - 0.5 - wave.position(time)) < bound);
        BOOST_TEST(std::abs(shot.velocities(d, 0)) == std::abs(start.velocities(d, 0)));
        hits += wave.hits(time);
    }
    BOOST_TEST(engine->tallies().wall_collisions == static_cast<std::uint64_t>(hits));
}

/// n balls on an open line collide at most n (n - 1) / 2 times, and that many when they are
/// ordered to meet most.
BOOST_AUTO_TEST_CASE(balls_on_a_line_meet_each_pair_once_before_the_walls) {
    Chain chain(8, 4000, 1);
    for (std::int64_t k = 0; k < 8; ++k) {
        chain.start.positions(0, k) = 1990 + 2.5 * static_cast<double>(k);
        chain.start.velocities(0, k) = 0.01 * (4.1 - static_cast<double>(k));
    }
    auto const engine = make_engine(chain.system, Method::fast, Precision::double_, chain.start);
    engine->advance({.time = 5000});
    BOOST_TEST(engine->tallies().ball_collisions == 28u);
    BOOST_TEST(engine->tallies().wall_collisions == 0u);
}

/// A head-on hit in the cradle: one comes, one goes, the others rest.
BOOST_AUTO_TEST_CASE(cradle_hands_the_velocity_to_the_last_ball) {
    Chain chain(5, 40, 1);
    chain.start.velocities.setZero();
    for (std::int64_t k = 0; k < 5; ++k)
        chain.start.positions(0, k) = 5 + 2 * static_cast<double>(k);
    chain.start.velocities(0, 0) = 1;
    auto const engine =
        make_engine(chain.system, Method::automatic, Precision::double_, chain.start);
    engine->advance({.time = 8});
    auto const shot = engine->snapshot();
    BOOST_TEST(engine->tallies().ball_collisions == 4u);
    BOOST_TEST(shot.velocities.leftCols(4).isZero());
    BOOST_TEST(shot.velocities(0, 4) == 1);
}

/// Touching balls that meet at one moment: the order is the engine's rule, the invariants are not.
BOOST_DATA_TEST_CASE(touching_cradle_keeps_momentum_and_energy, data::make(methods), method) {
    Chain chain(5, 40, 1);
    chain.start.velocities.setZero();
    for (std::int64_t k = 0; k < 5; ++k) chain.start.positions(0, k) = 5 + static_cast<double>(k);
    chain.start.velocities(0, 0) = 1;
    auto const engine = make_engine(chain.system, method, Precision::double_, chain.start);
    engine->advance({.time = 1});
    BOOST_TEST(engine->kinetic_energy() == 0.5);
    BOOST_TEST(engine->momentum()[0] == 1);
    BOOST_TEST(engine->snapshot().velocities(0, 4) == 1);
}

/// Run, turn all velocities round, run as long: the start comes back, magnified by chaos. At a
/// packing fraction of 0.2 an error grows e^0.8-fold a collision of each ball: six there and six
/// back leave e^10 roundings.
BOOST_DATA_TEST_CASE(reversed_run_comes_back_inside_its_horizon, data::make(methods), method) {
    for (Boundary const boundary : {Boundary::walls, Boundary::periodic}) {
        System system = made_up::system(boundary, 108, 0.2);
        Start start = made_up::lattice(system, 8);
        // Room at the walls, or the way back would end on the instant of a hit.
        system.side += 0.1;
        start.positions.array() += 0.05;
        auto const there = make_engine(system, method, Precision::double_, start);
        there->advance({.ball_collisions = 6 * 54});
        double const time = there->time() + 0x1p-20;
        there->advance({.time = time});
        Snapshot const turned = there->snapshot();
        auto const back = make_engine(system, method, Precision::double_,
                                      Start{turned.positions, -turned.velocities});
        back->advance({.time = time});
        Snapshot const home = back->snapshot();
        Eigen::Matrix3Xd apart = home.positions - start.positions;
        if (boundary == Boundary::periodic)
            apart = apart - system.side * (apart / system.side).array().round().matrix();
        BOOST_TEST(apart.cwiseAbs().maxCoeff() < 1e-9);
        BOOST_TEST((home.velocities + start.velocities).cwiseAbs().maxCoeff() < 1e-8);
    }
}
