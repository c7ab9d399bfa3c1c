// What the experiments on pressure and structure catch: wall_pressure, virial_coefficients,
// pair_correlation, system_size, crystal, freezing, equipartition. At a part of their size, where
// the mutant is seen from afar.

#include "validation/crystal.hpp"
#include "validation/equipartition.hpp"
#include "validation/freezing.hpp"
#include "validation/pair_correlation.hpp"
#include "validation/system_size.hpp"
#include "validation/virial_coefficients.hpp"
#include "validation/wall_pressure.hpp"

#include "state/errors.hpp"
#include "tests/validation/mutants.hpp"
#include "validation/mutants/mutants.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace clack;
using namespace clack::validation;

namespace {

template <class Measurer>
std::vector<Measurement> replicates_of(int const count, Measurer const& measure) {
    std::vector<Measurement> replicates;
    for (int k = 1; k <= count; ++k) replicates.push_back(measure(static_cast<std::uint64_t>(k)));
    return replicates;
}

/// The verdict on one of the quantities.
Verdict verdict_on(Ledger& ledger, std::string const& quantity) {
    ledger.judge({.false_alarm = 0.01}); // a part of an experiment decides less surely
    BOOST_TEST_MESSAGE(ledger.text());
    return ledger.verdict(quantity);
}

} // namespace

BOOST_AUTO_TEST_CASE(walls_off_by_a_thousandth_do_not_pass) {
    wall_pressure::StatePoint point = wall_pressure::state_points(Profile::quick).front();
    point.production = 200'000; // half of the experiment's, of which half as many replicates
    auto const verdict = [&](EngineMaker const& make) {
        Ledger ledger({Key{"side", ""}});
        wall_pressure::enter(
            ledger, point,
            replicates_of(
                8, [&](std::uint64_t seed) { return wall_pressure::measure(point, seed, make); }),
            {});
        return verdict_on(ledger, "two_balls_impulse");
    };
    BOOST_TEST((verdict(make_true_engine) != Verdict::differs));
    BOOST_TEST((verdict(with(Fault::moved_walls)) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(lost_refresh_changes_the_virial_coefficients) {
    using namespace virial_coefficients;
    auto points = runs(Profile::quick);
    for (PeriodicRun& run : points) run.production = 100;
    auto const verdict = [&](EngineMaker const& make) {
        std::vector<std::vector<Measurement>> all;
        for (PeriodicRun const& run : points)
            all.push_back(replicates_of(
                4, [&](std::uint64_t const seed) { return measure(run, seed, make); }));
        Ledger ledger({Key{"order", ""}});
        enter(ledger, points, all, Profile::quick);
        return verdict_on(ledger, "B2");
    };
    BOOST_TEST((verdict(make_true_engine) != Verdict::differs));
    try {
        BOOST_TEST((verdict(with(Fault::lost_refresh)) == Verdict::differs));
    } catch (LawBroken const& broken) { // balls that pass unseen may come to overlap first
        BOOST_TEST_MESSAGE(broken.what());
    }
}

BOOST_AUTO_TEST_CASE(virial_fit_finds_the_coefficients_of_the_theory) {
    auto const points = virial_coefficients::runs(Profile::quick);
    std::vector<double> exact;
    for (PeriodicRun const& run : points) exact.push_back(run.expected());
    auto const fitted = virial_coefficients::fit(points, exact);
    // what the series leaves out of the theory at the densest points
    BOOST_TEST(std::abs(fitted[0] - 4) < 1e-4);
    BOOST_TEST(std::abs(fitted[1] - 10) < 5e-3);
    BOOST_TEST(std::abs(fitted[2] - 18.36477) < 3e-2);
}

BOOST_AUTO_TEST_CASE(wider_balls_are_missed_at_contact) {
    auto point = pair_correlation::state_points(Profile::quick).back();
    point.production = point.equilibration = 40;
    point.looks = 20;
    auto const verdict = [&](EngineMaker const& make) {
        Ledger ledger({Key{"packing_fraction", ""}});
        pair_correlation::enter(ledger, point,
                                replicates_of(6,
                                              [&](std::uint64_t seed) {
                                                  return pair_correlation::measure(point, seed,
                                                                                   make);
                                              }),
                                {});
        return verdict_on(ledger, "contact");
    };
    BOOST_TEST((verdict(make_true_engine) != Verdict::differs));
    BOOST_TEST((verdict(with(Fault::wider_balls)) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(temperature_of_n_instead_of_n_minus_1_balls_has_another_slope) {
    auto const points = system_size::state_points(Profile::quick);
    auto const verdict = [&](bool const mistaken) {
        std::vector<std::vector<Measurement>> all;
        for (auto const& point : points) {
            auto const n = static_cast<double>(point.count);
            double z = point.expected();
            if (mistaken) z = 1 + (z - 1 + 1 / n) * n / (n - 1);
            all.push_back(replicates_of(16, [&](std::uint64_t const seed) {
                return Measurement{z + (seed % 2 == 0 ? 5e-3 : -5e-3)}; // as the runs scatter
            }));
        }
        Ledger ledger({Key{"count", ""}});
        system_size::enter(ledger, points, all);
        return verdict_on(ledger, "slope");
    };
    BOOST_TEST((verdict(false) == Verdict::agrees));
    BOOST_TEST((verdict(true) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(grazing_collisions_that_are_missed_lower_every_size) {
    auto points = system_size::state_points(Profile::quick);
    std::erase_if(points,
                  [](PeriodicRun const& run) { return run.count < 108 || run.count > 500; });
    for (PeriodicRun& run : points) run.production *= 0.1, run.equilibration = 30;
    auto const verdict = [&](EngineMaker const& make) {
        std::vector<std::vector<Measurement>> all;
        for (auto const& run : points)
            all.push_back(replicates_of(8, [&](std::uint64_t const seed) {
                return system_size::measure(run, seed, make);
            }));
        Ledger ledger({Key{"count", ""}});
        system_size::enter(ledger, points, all);
        return verdict_on(ledger, "Z");
    };
    BOOST_TEST((verdict(make_true_engine) != Verdict::differs));
    BOOST_TEST((verdict([](Scene const& scene) {
                    return mutants::make<PeriodicCube, mutants::MissedGrazing>(scene);
                }) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(wider_balls_press_too_much_in_a_crystal) {
    PeriodicRun run{{0.72, 500, Arrangement::fcc}, 20, 20};
    auto const verdict = [&](EngineMaker const& make, char const* const quantity) {
        Ledger ledger({Key{"packing_fraction", ""}});
        crystal::enter(ledger, run, replicates_of(6, [&](std::uint64_t const seed) {
                           return crystal::measure(run, seed, make);
                       }));
        return verdict_on(ledger, quantity);
    };
    BOOST_TEST((verdict(make_true_engine, "virial") != Verdict::differs));
    BOOST_TEST((verdict(make_true_engine, "bond_order") == Verdict::agrees));
    BOOST_TEST((verdict(with(Fault::wider_balls), "virial") == Verdict::differs));
    run.packing_fraction = 0.52;
    run.arrangement = Arrangement::random; // a fluid is no crystal
    BOOST_TEST((verdict(make_true_engine, "bond_order") == Verdict::differs));
}

namespace {

/// The verdict on balls at rest on a lattice that fills a cube of number density 1, as if known to
/// 1e-3: cells of `edges`, so many of them that all sides are equal or, for hcp, nearly so.
Verdict verdict_on_lattice(Eigen::Vector3d const& edges, Eigen::Vector3i const& cells,
                           std::vector<Eigen::Vector3d> const& sites) {
    Snapshot shot;
    System system;
    system.boundary = Boundary::periodic;
    system.count = static_cast<std::int64_t>(sites.size()) * cells.prod();
    system.side = std::cbrt(static_cast<double>(system.count));
    shot.positions.resize(3, system.count);
    Eigen::Index k = 0;
    for (int x = 0; x < cells.x(); ++x)
        for (int y = 0; y < cells.y(); ++y)
            for (int z = 0; z < cells.z(); ++z)
                for (Eigen::Vector3d const& site : sites)
                    shot.positions.col(k++) =
                        system.side *
                        (Eigen::Vector3d(x, y, z) + site).cwiseQuotient(cells.cast<double>());
    Eigen::Vector3d const sides = edges.cwiseProduct(cells.cast<double>());
    BOOST_TEST(sides.maxCoeff() / sides.minCoeff() < 1.1);
    PeriodicRun const run{{std::numbers::pi / 6, system.count}, 0, 0};
    double const order = bond_order(system, shot, crystal::bond_reach(run));
    BOOST_TEST_MESSAGE("bond order " << order);
    return judge({crystal::beside_fcc({order, 1e-3})}).front().verdict;
}

} // namespace

BOOST_AUTO_TEST_CASE(other_lattices_do_not_pass_for_the_face_centred_one) {
    BOOST_TEST((verdict_on_lattice({1, 1, 1}, {5, 5, 5},
                                   {{0, 0, 0}, {0, .5, .5}, {.5, 0, .5}, {.5, .5, 0}}) ==
                Verdict::agrees));
    BOOST_TEST(
        (verdict_on_lattice({1, 1, 1}, {6, 6, 6}, {{0, 0, 0}, {.5, .5, .5}}) == Verdict::differs));
    // hexagonal close packing in cells of four balls
    BOOST_TEST((verdict_on_lattice({1, std::sqrt(3.0), std::sqrt(8.0 / 3)}, {5, 3, 3},
                                   {{0, 0, 0}, {.5, .5, 0}, {.5, 1.0 / 6, .5}, {0, 2.0 / 3, .5}}) ==
                Verdict::differs));
}

BOOST_AUTO_TEST_CASE(wider_balls_leave_the_branch_of_the_crystal) {
    PeriodicRun run = freezing::branches(Profile::quick).crystal.back();
    run.production = 100;
    auto const verdict = [&](EngineMaker const& make) {
        Ledger ledger({Key{"number_density", ""}});
        freezing::enter(ledger, run, replicates_of(run.replicates, [&](std::uint64_t const seed) {
                            return freezing::measure(run, seed, make);
                        }));
        return verdict_on(ledger, "crystal");
    };
    BOOST_TEST((verdict(make_true_engine) != Verdict::differs));
    BOOST_TEST((verdict(with(Fault::wider_balls)) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(branches_meet_where_they_should_and_shifted_ones_do_not) {
    auto const both = freezing::branches(Profile::quick);
    auto const meeting = [&](double const factor_of_fluid) {
        std::vector<double> fluid, solid;
        for (PeriodicRun const& run : both.fluid) fluid.push_back(factor_of_fluid * run.expected());
        for (PeriodicRun const& run : both.crystal) solid.push_back(run.expected());
        return freezing::meeting_pressure(freezing::Branch(both.fluid, fluid),
                                          freezing::Branch(both.crystal, solid));
    };
    // the same construction by another program from the same equations of state: 11.5680
    BOOST_TEST(std::abs(meeting(1) - 11.5680) < 1e-3);
    double const margin = freezing::meeting_margin * reference::coexistence_pressure;
    BOOST_TEST(std::abs(meeting(1.03) - reference::coexistence_pressure) > margin);
}

BOOST_AUTO_TEST_CASE(balls_that_swap_their_velocities_keep_the_shares_of_the_start) {
    equipartition::StatePoint const point = equipartition::state_points.front();
    using Maker = std::unique_ptr<Engine> (*)(System const&, Start const&);
    auto const verdict = [&](Maker const make) {
        auto const from_flat_start = [&](Scene const& scene) {
            Start start = make_start(scene);
            start.velocities.row(2) /= 2;
            return make(scene.system, start);
        };
        Ledger ledger({{"packing_fraction", ""}, {"axis", ""}});
        equipartition::enter(ledger, point, replicates_of(6, [&](std::uint64_t const seed) {
                                 return equipartition::measure(point, seed, from_flat_start);
                             }));
        return verdict_on(ledger, "share");
    };
    BOOST_TEST((verdict(mutants::make<WalledCube, ElasticBalls>) != Verdict::differs));
    BOOST_TEST(
        (verdict(mutants::make<WalledCube, mutants::SwappedVelocities>) == Verdict::differs));
}
