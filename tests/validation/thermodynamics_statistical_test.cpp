// What the experiments on pressure and structure catch: wall_pressure, virial_coefficients,
// pair_correlation, system_size, crystal, freezing. At a part of their size, where the mutant is
// seen from afar.

#include "validation/crystal.hpp"
#include "validation/freezing.hpp"
#include "validation/pair_correlation.hpp"
#include "validation/system_size.hpp"
#include "validation/virial_coefficients.hpp"
#include "validation/wall_pressure.hpp"

#include "state/errors.hpp"
#include "tests/validation/mutants.hpp"

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

std::unique_ptr<Engine> make_wider_balls(Scene const& scene) {
    Scene wider = scene; // it must not start with overlaps
    wider.system.diameter *= mutants::WiderBalls<double>::widening;
    return mutants::make<PeriodicCube, mutants::WiderBalls>(scene.system, make_start(wider));
}

/// The verdict on one of the findings.
Verdict verdict_on(Findings& findings, std::string const& quantity) {
    findings.judge({.false_alarm = 0.01}); // a part of an experiment decides less surely
    for (Finding const& finding : findings.all())
        if (finding.quantity == quantity) {
            BOOST_TEST_MESSAGE(finding.comparison.name
                               << ": " << finding.comparison.measured.value << " +- "
                               << finding.comparison.measured.error << ", expected "
                               << finding.comparison.reference);
            return finding.judgement.verdict;
        }
    throw std::logic_error("no such finding");
}

} // namespace

BOOST_AUTO_TEST_CASE(walls_off_by_a_thousandth_do_not_pass) {
    wall_pressure::StatePoint point = wall_pressure::state_points(Profile::quick).front();
    point.production = 200'000; // half of the experiment's, of which half as many replicates
    auto const verdict = [&](EngineMaker const& make) {
        Findings findings("side", "");
        wall_pressure::add_exact(findings, point, replicates_of(8, [&](std::uint64_t seed) {
                                     return wall_pressure::measure(point, seed, make);
                                 }));
        return verdict_on(findings, "two_balls_impulse");
    };
    BOOST_TEST((verdict(make_true_engine) != Verdict::differs));
    BOOST_TEST((verdict([](Scene const& scene) {
                    return mutants::make<WalledCube, mutants::MovedWalls>(scene);
                }) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(lost_refresh_changes_the_virial_coefficients) {
    using namespace virial_coefficients;
    Verdict verdict = Verdict::differs;
    auto points = runs(Profile::quick);
    for (PeriodicRun& run : points) run.production = 100;
    try {
        std::vector<std::vector<Measurement>> all;
        for (PeriodicRun const& run : points)
            all.push_back(replicates_of(4, [&](std::uint64_t const seed) {
                return virial_coefficients::measure(run, seed, [](Scene const& scene) {
                    return mutants::make<PeriodicCube, mutants::LostRefresh>(scene);
                });
            }));
        Findings findings("order", "");
        virial_coefficients::add_findings(findings, points, all);
        verdict = verdict_on(findings, "B2");
    } catch (LawBroken const& broken) { // balls that pass unseen may come to overlap first
        BOOST_TEST_MESSAGE(broken.what());
    }
    BOOST_TEST((verdict == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(virial_fit_finds_the_coefficients_of_the_theory) {
    auto const points = virial_coefficients::runs(Profile::quick);
    std::vector<double> exact;
    for (PeriodicRun const& run : points)
        exact.push_back(reference::periodic_compressibility(run.number_density(), run.count));
    auto const fitted = virial_coefficients::fit(points, exact);
    // what the series leaves out of the theory at the densest points
    BOOST_TEST(std::abs(fitted[0] - 4) < 1e-4);
    BOOST_TEST(std::abs(fitted[1] - 10) < 5e-3);
    BOOST_TEST(std::abs(fitted[2] - 18.36477) < 3e-2);
}

BOOST_AUTO_TEST_CASE(wider_balls_are_missed_at_contact) {
    auto point = pair_correlation::state_points(Profile::quick).back();
    point.run.production = point.run.equilibration = 40;
    point.looks = 20;
    auto const verdict = [&](EngineMaker const& make) {
        Findings findings("packing_fraction", "");
        pair_correlation::add_findings(findings, point, replicates_of(6, [&](std::uint64_t seed) {
                                           return pair_correlation::measure(point, seed, make);
                                       }));
        return verdict_on(findings, "contact");
    };
    BOOST_TEST((verdict(make_true_engine) != Verdict::differs));
    BOOST_TEST((verdict(make_wider_balls) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(temperature_of_n_instead_of_n_minus_1_balls_has_another_slope) {
    auto const points = system_size::state_points(Profile::quick);
    auto const verdict = [&](bool const mistaken) {
        std::vector<std::vector<Measurement>> all;
        for (auto const& point : points) {
            auto const n = static_cast<double>(point.run.count);
            double z =
                reference::periodic_compressibility(point.run.number_density(), point.run.count);
            if (mistaken) z = 1 + (z - 1 + 1 / n) * n / (n - 1);
            all.push_back(replicates_of(16, [&](std::uint64_t const seed) {
                return Measurement{z + (seed % 2 == 0 ? 5e-3 : -5e-3)}; // as the runs scatter
            }));
        }
        Findings findings("count", "");
        system_size::add_findings(findings, points, all);
        return verdict_on(findings, "slope");
    };
    BOOST_TEST((verdict(false) == Verdict::agrees));
    BOOST_TEST((verdict(true) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(wider_balls_press_too_much_in_a_crystal) {
    PeriodicRun run{0.72, 500, 20, 20, Arrangement::fcc};
    auto const verdict = [&](EngineMaker const& make, char const* const quantity) {
        Findings findings("packing_fraction", "");
        crystal::add_findings(findings, run, replicates_of(6, [&](std::uint64_t const seed) {
                                  return crystal::measure(run, seed, make);
                              }));
        return verdict_on(findings, quantity);
    };
    BOOST_TEST((verdict(make_true_engine, "virial") != Verdict::differs));
    BOOST_TEST((verdict(make_true_engine, "bond_order") == Verdict::agrees));
    BOOST_TEST((verdict(make_wider_balls, "virial") == Verdict::differs));
    run.packing_fraction = 0.52;
    run.arrangement = Arrangement::random; // a fluid is no crystal
    BOOST_TEST((verdict(make_true_engine, "bond_order") == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(wider_balls_leave_the_branch_of_the_crystal) {
    PeriodicRun run = freezing::branches(Profile::quick).crystal.back();
    run.production = 100;
    Findings findings("number_density", "");
    freezing::add_branch(findings, run,
                         replicates_of(freezing::replicates, [&](std::uint64_t const seed) {
                             return freezing::measure(run, seed, make_wider_balls);
                         }));
    BOOST_TEST((verdict_on(findings, "crystal") == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(branches_meet_where_they_should_and_shifted_ones_do_not) {
    auto const both = freezing::branches(Profile::quick);
    auto const meeting = [&](double const factor_of_fluid) {
        std::vector<double> fluid, solid;
        for (PeriodicRun const& run : both.fluid)
            fluid.push_back(factor_of_fluid * freezing::theory_of(run));
        for (PeriodicRun const& run : both.crystal) solid.push_back(freezing::theory_of(run));
        return freezing::meeting_pressure(freezing::Branch(both.fluid, fluid),
                                          freezing::Branch(both.crystal, solid));
    };
    // the same construction by another program from the same equations of state: 11.5680
    BOOST_TEST(std::abs(meeting(1) - 11.5680) < 1e-3);
    double const margin = freezing::meeting_margin * reference::coexistence_pressure;
    BOOST_TEST(std::abs(meeting(1.03) - reference::coexistence_pressure) > margin);
}
