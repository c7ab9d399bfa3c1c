// What the experiment catches, with the settings and seeds of its quick profile. Skipped where
// LAMMPS is not installed.

#include "validation/pressure_vs_lammps.hpp"

#include "tests/reference/needs_lammps.hpp"

#include <boost/test/unit_test.hpp>

using namespace clack;
using namespace clack::validation;
using namespace clack::validation::pressure_vs_lammps;

namespace {

Verdict verdict_of(StatePoint const& point, std::vector<Measurement> const& replicates) {
    Ledger ledger({{"packing_fraction", ""}, {"stiffness", ""}});
    enter(ledger, point, replicates, margin(Profile::quick));
    ledger.judge(risks);
    BOOST_TEST_MESSAGE(ledger.text());
    return ledger.verdict();
}

} // namespace

BOOST_AUTO_TEST_CASE(widened_balls_are_as_wide_as_hard_ones) {
    for (double const k : {1e3, 1e5}) {
        double const wide = diameter_of(Width::widened, k);
        BOOST_TEST(std::abs(reference::barker_henderson_diameter(wide, k, 1) - 1) < 1e-15);
        BOOST_TEST(diameter_of(Width::plain, k) == 1);
    }
}

/// One stiffness of the quick profile by itself.
BOOST_AUTO_TEST_CASE(widened_balls_pass_and_plain_ones_do_not, *NeedsLammps()) {
    StatePoint point = state_points(Profile::quick).back();
    point.stiffnesses = {1.6e4};
    point.first_judged = 0;
    std::vector<Measurement> replicates;
    for (int replicate = 0; replicate < point.replicates; ++replicate)
        replicates.push_back(
            measure(point, seed_of("pressure_vs_lammps", point.text(), replicate)));
    BOOST_TEST((verdict_of(point, replicates) == Verdict::agrees));
    std::size_t const plain = place_of(0, Width::plain), wide = place_of(0, Width::widened);
    for (Measurement& replicate : replicates) replicate[wide] = replicate[plain];
    BOOST_TEST((verdict_of(point, replicates) == Verdict::differs));
}
