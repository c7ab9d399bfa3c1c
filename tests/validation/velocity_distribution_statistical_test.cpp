// What the experiment catches, at the size and with the settings of its quick profile.

#include "validation/velocity_distribution.hpp"
#include "validation/velocity_relaxation.hpp"

#include "tests/validation/harness/temporary_directory.hpp"
#include "validation/mutants/mutants.hpp"
#include "validation/records/campaign.hpp"
#include "validation/tools/regression.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <stdexcept>

using namespace clack;
using namespace clack::validation;
using namespace clack::validation::velocity_distribution;

namespace {

StatePoint point_of(std::int64_t const count) {
    for (StatePoint const& point : state_points(Profile::quick))
        if (point.count == count) return point;
    throw std::logic_error("no such point");
}

/// The experiment's own seeds, so that the true engine's verdict is the one it has there.
std::vector<Measurement> replicates_of(StatePoint const& point, EngineMaker const& make) {
    std::vector<Measurement> replicates;
    for (int replicate = 0; replicate < point.replicates; ++replicate)
        replicates.push_back(
            measure(point, seed_of("velocity_distribution", point.text(), replicate), make));
    return replicates;
}

/// The verdict on one point when it is one of all.
constexpr std::int64_t count = 32;
Verdict verdict_of(std::vector<Measurement> const& replicates) {
    double const points = static_cast<double>(state_points(Profile::quick).size());
    Ledger ledger({Key{"count", ""}});
    enter(ledger, point_of(count), replicates);
    ledger.judge({.false_alarm = Risks{}.false_alarm / points});
    BOOST_TEST_MESSAGE(ledger.text());
    return ledger.verdict();
}

} // namespace

BOOST_AUTO_TEST_CASE(true_engine_passes_and_another_law_does_not) {
    auto const replicates = replicates_of(point_of(count), make_true_engine);
    BOOST_TEST((verdict_of(replicates) == Verdict::agrees));

    // Maxwell and Boltzmann's law is another.
    Ledger maxwell({Key{"count", ""}});
    enter(maxwell, point_of(count), replicates);
    Comparison moment = maxwell.entries().front().comparison;
    moment.reference = reference::MaxwellBoltzmann::fourth_moment_ratio;
    BOOST_TEST((judge({moment}).front().verdict == Verdict::differs));
    auto const limit = bin_probabilities(reference::MaxwellBoltzmann(1, 1));
    BOOST_TEST(chi_square(counts_of(replicates), limit).p_value < 1e-4);
}

BOOST_AUTO_TEST_CASE(impulses_wrong_by_a_ten_thousandth_do_not_pass) {
    auto const replicates = replicates_of(point_of(count), with(Fault::weaker_impulses));
    BOOST_TEST((verdict_of(replicates) == Verdict::differs));
}

namespace {

/// The relaxation as the campaign would record it, beside the committed baseline.
std::size_t values_shifted_with(EngineMaker const& make) {
    TemporaryDirectory const directory("regression");
    Relaxation const relaxation;
    // Other seeds than the baseline's.
    Campaign campaign("velocity_distribution", directory.path, "", 1);
    campaign.replicates(relaxation.text(), relaxation.replicates,
                        [&](std::uint64_t const seed) { return measure(relaxation, seed, make); });
    auto const all = shifts(read_baseline(CLACK_SOURCE_DIR "/validation/baseline.csv"),
                            known_of(directory.path, "velocity_distribution", ""));
    BOOST_TEST(all.size() == 2 * relaxation_looks().size());
    BOOST_TEST_MESSAGE("largest z " << all.front().z << " at place " << all.front().now.place);
    return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](Shift const& shift) {
        return shift.p < regression_false_alarm;
    }));
}

} // namespace

// Equilibrium forgives a start, so no gate against theory sees this one; false alarm of the true
// engine: 1e-3.
BOOST_AUTO_TEST_CASE(start_that_theory_forgives_shifts_from_the_baseline) {
    auto const replicates = replicates_of(point_of(count), with(Fault::unequal_speeds));
    BOOST_TEST((verdict_of(replicates) == Verdict::agrees));
    BOOST_TEST(values_shifted_with(make_true_engine) == 0);
    BOOST_TEST(values_shifted_with(with(Fault::unequal_speeds)) > 0);
}

BOOST_AUTO_TEST_CASE(equal_speeds_start_to_part_as_chaos_among_molecules_says) {
    Relaxation const relaxation;
    std::vector<double> rises;
    for (int replicate = 0; replicate < relaxation.replicates; ++replicate) {
        Measurement const values =
            measure(relaxation, seed_of("velocity_distribution", relaxation.text(), replicate));
        rises.push_back((values[1] - 1) / values[0]);
    }
    // At 0.1 collisions a ball the rise has bent by about 1 %, half a standard error of 200 starts.
    Estimate const rise = mean_of(rises);
    BOOST_TEST_MESSAGE("first rise " << rise.value << " +- " << rise.error);
    BOOST_TEST(std::abs(rise.value - first_rise) < 4 * rise.error);
    BOOST_TEST(rise.error < 0.02 * first_rise);
}
