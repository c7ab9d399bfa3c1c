// What the experiment catches, at the size and with the settings of its quick profile.

#include "validation/equation_of_state.hpp"

#include "state/errors.hpp"
#include "validation/mutants/mutants.hpp"
#include "validation/records/campaign.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <stdexcept>

using namespace clack;
using namespace clack::validation;
using namespace clack::validation::equation_of_state;

namespace {

StatePoint point_at(double const packing_fraction) {
    for (StatePoint const& point : state_points(Profile::quick))
        if (point.packing_fraction == packing_fraction) return point;
    throw std::logic_error("no such point");
}

/// The experiment's own seeds, so that the true engine's verdict is the one it has there.
std::vector<Measurement> replicates_of(StatePoint const& point, EngineMaker const& make) {
    std::vector<Measurement> replicates;
    for (int replicate = 0; replicate < point.replicates; ++replicate)
        replicates.push_back(
            measure(point, seed_of("equation_of_state", point.text(), replicate), make));
    return replicates;
}

/// The verdict on one point when it is one of all.
Verdict verdict_of(StatePoint const& point, std::vector<Measurement> const& replicates) {
    double const points = static_cast<double>(state_points(Profile::quick).size());
    Ledger ledger({Key{"packing_fraction", ""}});
    enter(ledger, point, replicates, Profile::quick);
    ledger.judge({.false_alarm = Risks{}.false_alarm / points});
    BOOST_TEST_MESSAGE(ledger.text());
    return ledger.verdict();
}

} // namespace

BOOST_AUTO_TEST_CASE(true_engine_passes_and_one_with_wider_balls_does_not) {
    StatePoint const point = point_at(0.3);
    BOOST_TEST((verdict_of(point, replicates_of(point, make_true_engine)) == Verdict::agrees));
    BOOST_TEST(
        (verdict_of(point, replicates_of(point, with(Fault::wider_balls))) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(temperature_of_n_instead_of_n_minus_1_balls_does_not_pass) {
    StatePoint const point = point_at(0.1);
    auto replicates = replicates_of(point, make_true_engine);
    BOOST_TEST((verdict_of(point, replicates) == Verdict::agrees));
    // kT = 2E/(3N) makes the kinetic part 1 and the collisional one larger by N/(N-1)
    auto const n = static_cast<double>(point.count);
    for (Measurement& measurement : replicates)
        for (double& z : measurement) z = 1 + (z - 1 + 1 / n) * n / (n - 1);
    BOOST_TEST((verdict_of(point, replicates) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(lost_refresh_does_not_pass) {
    // Balls that pass unseen come to overlap: the engine's own law may stop the run first.
    StatePoint const point = point_at(0.05);
    Verdict verdict = Verdict::undecided;
    try {
        verdict = verdict_of(point, replicates_of(point, with(Fault::lost_refresh)));
    } catch (LawBroken const& broken) {
        BOOST_TEST_MESSAGE(broken.what());
        verdict = Verdict::differs;
    }
    BOOST_TEST((verdict == Verdict::differs));
}
