// What the experiments on collisions, chains, relaxation and the motion of single balls catch, with
// the settings of their quick profile; where a replicate would be long, with fewer of them.

#include "validation/collision_statistics.hpp"
#include "validation/relaxation.hpp"
#include "validation/self_diffusion.hpp"
#include "validation/tonks_gas.hpp"
#include "validation/transport.hpp"
#include "validation/velocity_autocorrelation.hpp"

#include "tests/validation/mutants.hpp"
#include "validation/records/campaign.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace clack;
using namespace clack::validation;

namespace {

/// A part of an experiment decides less surely than the whole.
Risks const of_a_part{.false_alarm = 0.01};

template <template <class> class Container, template <class> class Model>
std::unique_ptr<Engine> mutant(Scene const& scene) {
    return mutants::make<Container, Model>(scene);
}

/// The experiment's own seeds, so that the true engine's verdict is the one it has there.
template <class Point, class Measure>
std::vector<Measurement> replicates_of(std::string const& experiment, Point const& point,
                                       int const replicates, Measure&& measure) {
    std::vector<Measurement> all;
    for (int k = 0; k < replicates; ++k)
        all.push_back(measure(point, seed_of(experiment, point.text(), k)));
    return all;
}

/// An engine that forgets how often its balls have left the periodic cube.
class LostImages : public Engine {
public:
    explicit LostImages(std::unique_ptr<Engine> engine) : engine_(std::move(engine)) {}

    Stop advance(Goal const& goal, CollisionObserver* observer) override {
        return engine_->advance(goal, observer);
    }
    Snapshot snapshot() const override {
        Snapshot shot = engine_->snapshot();
        shot.images.setZero();
        return shot;
    }
    void start_clock() override { engine_->start_clock(); }
    void hash_collisions() override { engine_->hash_collisions(); }
    double time() const override { return engine_->time(); }
    Tallies const& tallies() const override { return engine_->tallies(); }
    std::uint64_t hash() const override { return engine_->hash(); }
    double kinetic_energy() const override { return engine_->kinetic_energy(); }
    Eigen::Vector3d momentum() const override { return engine_->momentum(); }
    Checkpoint checkpoint() const override { return engine_->checkpoint(); }
    System const& system() const override { return engine_->system(); }
    ModelDescription model() const override { return engine_->model(); }
    std::size_t bytes() const override { return engine_->bytes(); }

private:
    std::unique_ptr<Engine> engine_;
};

} // namespace

// Each case: all true comparisons agree or are undecided with a false alarm of 1 %; the mutant's
// verdict on the quantity that is made to notice it differs.

BOOST_AUTO_TEST_CASE(grazing_collisions_that_are_missed_do_not_pass) {
    using namespace collision_statistics;
    StatePoint const point = state_points(Profile::quick).front(); // 8 balls between walls
    auto const ledger_of = [&](EngineMaker const& make) {
        Ledger ledger({{"boundary", ""}, {"count", ""}, {"packing_fraction", ""}});
        enter(ledger, point,
              replicates_of("collision_statistics", point, point.replicates,
                            [&](auto const& p, auto seed) { return measure(p, seed, make); }));
        ledger.judge(of_a_part);
        BOOST_TEST_MESSAGE(ledger.text());
        return ledger;
    };
    BOOST_TEST((ledger_of(make_true_engine).verdict() == Verdict::agrees));
    auto const caught = ledger_of(mutant<WalledCube, mutants::MissedGrazing>);
    BOOST_TEST((caught.verdict("impact_squared") == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(chain_between_walls_off_by_a_thousandth_does_not_pass) {
    using namespace tonks_gas;
    StatePoint const point = state_points(Profile::quick)[1]; // 10 balls, double
    auto const ledger_of = [&](ChainMaker const& make) {
        Ledger ledger({{"count", ""}, {"precision", ""}});
        enter(ledger, point,
              replicates_of("tonks_gas", point, point.replicates,
                            [&](auto const& p, auto seed) { return measure(p, seed, make); }));
        BOOST_TEST_MESSAGE(ledger.text());
        return ledger;
    };
    BOOST_TEST((ledger_of(make_true_chain).verdict() == Verdict::agrees));
    auto const moved = [](System const& system, Precision, Start const& start) {
        return mutants::make<WalledCube, mutants::MovedWalls>(system, start);
    };
    auto const caught = ledger_of(moved);
    for (char const* const quantity : {"place", "wall_force", "collisions"})
        BOOST_TEST((caught.verdict(quantity) == Verdict::differs), quantity);
}

// A collision at time 0 would be counted by the engine and not among the ghosts.
BOOST_AUTO_TEST_CASE(no_chain_starts_with_a_contact) {
    using namespace tonks_gas;
    StatePoint const point = state_points(Profile::quick)[2];           // 100 balls
    auto const places = Chain(point, 7'066'528'904'600'260'980).places; // the draws have one twice
    for (std::size_t i = 1; i < places.size(); ++i) BOOST_TEST(places[i] > places[i - 1] + 1);
}

// Starts in fractions of two would have collisions there.
BOOST_AUTO_TEST_CASE(no_look_at_a_chain_is_near_a_simple_fraction) {
    using namespace tonks_gas;
    for (int k = 0; k < look_count; ++k) {
        for (int below = 1; below <= 1000; ++below) {
            double const above = look_time(k) * below;
            BOOST_TEST(std::abs(above - std::round(above)) * below > 0.38); // Hurwitz: 1 / sqrt 5
        }
    }
}

BOOST_AUTO_TEST_CASE(rounded_velocities_take_balls_on_a_line_farther_than_rounded_places) {
    using namespace tonks_gas;
    StatePoint const point = state_points(Profile::quick)[0]; // 10 balls, float
    Measurement const values = measure(point, 6822); // of 12 000 starts the one that strays most
    double beside_places = 0, beside_bound = 0;
    for (std::size_t k = 0; k < look_count; ++k) {
        double const* const seen = values.data() + k * value_count;
        double const collisions = seen[collisions_per_ball];
        double const of_places = 4 * point.roundoff() * point.side * (1 + collisions);
        beside_places = std::max(beside_places, seen[place_error] / of_places);
        beside_bound = std::max(beside_bound, seen[place_error] / place_bound(point, collisions));
    }
    BOOST_TEST(beside_places > 1.5);
    BOOST_TEST(beside_bound < 0.5);
}

BOOST_AUTO_TEST_CASE(balls_that_swap_their_velocities_never_relax) {
    using namespace relaxation;
    StatePoint const point = state_points(Profile::quick).front(); // from equal speeds
    constexpr int replicates = 40;                                 // of the 240
    auto const walks = replicates_of("relaxation", point, 200,
                                     [](auto const& p, auto seed) { return walk(p, seed); });
    auto const verdict_of = [&](EngineMaker const& make) {
        Ledger ledger({{"start", ""}, {"time", ""}});
        enter(ledger, point,
              replicates_of("relaxation", point, replicates,
                            [&](auto const& p, auto seed) { return measure(p, seed, make); }),
              walks);
        ledger.judge(of_a_part);
        BOOST_TEST_MESSAGE(ledger.text());
        return ledger.verdict("excess_H");
    };
    BOOST_TEST((verdict_of(make_true_engine) != Verdict::differs));
    BOOST_TEST((verdict_of(mutant<WalledCube, mutants::SwappedVelocities>) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(displacements_in_a_wrapped_cube_do_not_pass) {
    using namespace self_diffusion;
    StatePoint const point = state_points(Profile::quick)[1]; // packing fraction 0.1
    auto const verdict_of = [&](EngineMaker const& make) {
        Ledger ledger({{"packing_fraction", ""}, {"count", ""}});
        enter(ledger, point,
              replicates_of("self_diffusion", point, 4,
                            [&](auto const& p, auto seed) { return measure(p, seed, make); }));
        ledger.judge(of_a_part);
        BOOST_TEST_MESSAGE(ledger.text());
        return ledger.verdict();
    };
    BOOST_TEST((verdict_of(make_true_engine) != Verdict::differs));
    auto const lost = [](Scene const& scene) {
        return std::make_unique<LostImages>(make_true_engine(scene));
    };
    BOOST_TEST((verdict_of(lost) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(balls_that_swap_their_velocities_forget_them_at_once) {
    using namespace velocity_autocorrelation;
    StatePoint const point = state_points(Profile::quick)[1]; // packing fraction 0.3
    auto const verdict_of = [&](EngineMaker const& make) {
        Ledger ledger({{"packing_fraction", ""}, {"count", ""}});
        enter(ledger, point,
              replicates_of("velocity_autocorrelation", point, 4,
                            [&](auto const& p, auto seed) { return measure(p, seed, make); }));
        ledger.judge(of_a_part);
        BOOST_TEST_MESSAGE(ledger.text());
        return ledger.verdict("initial_slope");
    };
    BOOST_TEST((verdict_of(make_true_engine) != Verdict::differs));
    BOOST_TEST((verdict_of(mutant<PeriodicCube, mutants::SwappedVelocities>) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(neither_boltzmann_nor_balls_that_miss_each_other_pass_for_enskog) {
    using namespace transport;
    auto const points = state_points(Profile::quick);
    StatePoint point = *std::find_if(points.begin(), points.end(), [](StatePoint const& p) {
        return p.fluid.packing_fraction == judged_up_to;
    });
    point.production /= 2;
    auto const ledger_of = [&](EngineMaker const& make) {
        Ledger ledger({{"packing_fraction", ""}, {"count", ""}});
        enter(ledger, point, replicates_of("transport", point, 8, [&](auto const& p, auto seed) {
                  return measure(p, seed, make);
              }));
        ledger.judge(of_a_part);
        BOOST_TEST_MESSAGE(ledger.text());
        return ledger;
    };
    auto const truly = ledger_of(make_true_engine);
    auto const missed = ledger_of(mutant<PeriodicCube, mutants::MissedHalf>);
    for (std::string const quantity : {"shear", "conductivity"}) {
        BOOST_TEST((truly.verdict(quantity) != Verdict::differs), quantity);
        BOOST_TEST((truly.verdict(quantity + "_not_boltzmann") == Verdict::agrees), quantity);
        BOOST_TEST((missed.verdict(quantity) == Verdict::differs), quantity);
    }
}

BOOST_AUTO_TEST_CASE(fluxes_of_few_balls_are_those_of_constant_energy_without_momentum) {
    constexpr int count = 8, draws = 100'000;
    std::mt19937_64 random(5);
    std::normal_distribution<> normal;
    std::vector<double> momentum, heat;
    for (int draw = 0; draw < draws; ++draw) {
        Eigen::Matrix3Xd v =
            Eigen::Matrix3Xd::NullaryExpr(3, count, [&] { return normal(random); });
        v.colwise() -= v.rowwise().mean().eval();
        v *= std::sqrt((3 * count - 3) / v.squaredNorm());
        double const momentum_flux = v.row(0).dot(v.row(1));
        double const heat_flux = v.row(0).dot(v.colwise().squaredNorm());
        momentum.push_back(momentum_flux * momentum_flux / count);
        heat.push_back(heat_flux * heat_flux / (10 * count)); // less what momentum carries
    }
    // four standard errors each: a false alarm of 1e-4
    auto const of_momentum = mean_of(momentum), of_heat = mean_of(heat);
    BOOST_TEST(std::abs(of_momentum.value - reference::momentum_flux_of(count)) <
               4 * of_momentum.error);
    BOOST_TEST(std::abs(of_heat.value - reference::heat_flux_of(count)) < 4 * of_heat.error);
}
