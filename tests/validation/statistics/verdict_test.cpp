#include "validation/statistics/verdict.hpp"

#include <boost/test/unit_test.hpp>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace clack::validation;

namespace {

constexpr Risks one_percent{.false_alarm = 0.01};

Verdict verdict_of(double const difference, double const error, double const margin) {
    return judge({Comparison{"x", {5 + difference, error}, 5, 0, margin}}, one_percent)[0].verdict;
}

} // namespace

BOOST_AUTO_TEST_CASE(small_difference_known_well_agrees) {
    BOOST_TEST((verdict_of(0.5, 0.25, 1) == Verdict::agrees)); // 2 errors inside the margin
    BOOST_TEST((verdict_of(-0.5, 0.25, 1) == Verdict::agrees));
}

BOOST_AUTO_TEST_CASE(large_difference_known_well_differs) {
    BOOST_TEST((verdict_of(2, 0.25, 1) == Verdict::differs)); // 4 errors outside
    BOOST_TEST((verdict_of(-2, 0.25, 1) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(difference_known_poorly_is_undecided) {
    BOOST_TEST((verdict_of(0, 2, 1) == Verdict::undecided));
    BOOST_TEST((verdict_of(2, 2, 1) == Verdict::undecided));
    BOOST_TEST((verdict_of(1, 0.1, 1) == Verdict::undecided)); // on the margin itself
}

BOOST_AUTO_TEST_CASE(difference_that_is_certain_but_within_the_margin_agrees) {
    auto const judged = judge({Comparison{"x", {5.5, 0.01}, 5, 0, 1}})[0];
    BOOST_TEST((judged.verdict == Verdict::agrees));
    BOOST_TEST(std::abs(judged.z - 50) < 1e-10); // and shows
}

BOOST_AUTO_TEST_CASE(few_replicates_weigh_less) {
    Comparison comparison{"x", {7, 0.25, 2}, 5, 0, 1};
    BOOST_TEST((judge({comparison}, one_percent)[0].verdict ==
                Verdict::undecided)); // t of 2: 4 is not rare
    comparison.measured.degrees_of_freedom = 50;
    BOOST_TEST((judge({comparison}, one_percent)[0].verdict == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(reference_error_counts) {
    Comparison const comparison{"x", {8, 3}, 0, 4, 1};
    BOOST_TEST(std::abs(judge({comparison})[0].z - 8.0 / 5) < 1e-15);
}

BOOST_AUTO_TEST_CASE(many_comparisons_need_a_larger_difference) {
    Comparison const odd{"odd", {5 + 1 + 2.6 * 0.2, 0.2}, 5, 0, 1}; // 2.6 errors outside
    Comparison const good{"good", {5, 0.2}, 5, 0, 1};
    BOOST_TEST((judge({odd}, one_percent)[0].verdict == Verdict::differs));
    auto const family = judge({odd, good, good, good, good, good}, one_percent);
    BOOST_TEST((family[0].verdict == Verdict::undecided));
    BOOST_TEST((family[1].verdict == Verdict::agrees));
}

BOOST_AUTO_TEST_CASE(false_verdicts_are_as_rare_as_stated) {
    gsl_rng* const random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, 3);
    constexpr int trials = 20'000;
    Risks const risks{.false_alarm = 0.05, .false_agreement = 0.05};
    int alarms = 0, agreements = 0;
    for (int k = 0; k < trials; ++k) {
        // the true difference is the margin: both answers would be wrong
        std::vector<double> replicates(8);
        for (double& value : replicates) value = 1 + gsl_ran_gaussian(random, 0.5);
        Verdict const verdict =
            judge({Comparison{"x", mean_of(replicates), 0, 0, 1}}, risks)[0].verdict;
        alarms += verdict == Verdict::differs;
        agreements += verdict == Verdict::agrees;
    }
    gsl_rng_free(random);
    double const expected = 0.05 * trials;
    BOOST_TEST(std::abs(alarms - expected) < 4 * std::sqrt(expected));
    BOOST_TEST(std::abs(agreements - expected) < 4 * std::sqrt(expected));
}

BOOST_AUTO_TEST_CASE(comparison_without_margin_or_error_is_refused) {
    BOOST_CHECK_THROW(judge({Comparison{"x", {1, 0.1}, 1, 0, 0}}), std::invalid_argument);
    BOOST_CHECK_THROW(judge({Comparison{"x", {1, 0}, 1, 0, 1}}), std::invalid_argument);
    BOOST_CHECK_THROW(judge({Comparison{"x", {1, NAN}, 1, 0, 1}}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(what_must_be_told_apart_agrees_only_where_it_is) {
    auto const verdict = [](double const difference, double const error) {
        Comparison const apart{"x", {5 + difference, error}, 5, 0, 1, Asks::whether_apart};
        return judge({apart}, one_percent)[0].verdict;
    };
    BOOST_TEST((verdict(2, 0.25) == Verdict::agrees));
    BOOST_TEST((verdict(0, 0.25) == Verdict::differs)); // would pass for what it must not be
    BOOST_TEST((verdict(2, 2) == Verdict::undecided));
}

BOOST_AUTO_TEST_CASE(at_least_has_no_upper_end) {
    auto const judged = [](double const value) {
        return judge({Comparison{"x", {value, 0.25}, 5, 0, 0, Asks::whether_at_least}})[0];
    };
    BOOST_TEST((judged(1e9).verdict == Verdict::agrees));
    BOOST_TEST(judged(1e9).against == 0); // being better than asked for is no deviation
    BOOST_TEST((judged(5).verdict == Verdict::undecided));
    BOOST_TEST((judged(3).verdict == Verdict::differs));
    BOOST_TEST(judged(3).against == 8);
}

BOOST_AUTO_TEST_CASE(law_is_refused_by_a_small_p_value_after_holm) {
    auto const one = judge(std::vector{0.006}, 0.01);
    BOOST_TEST((one[0] == Verdict::differs));
    auto const two = judge({0.006, 0.5}, 0.01);
    BOOST_TEST((two[0] == Verdict::agrees));
}

BOOST_AUTO_TEST_CASE(one_difference_spoils_all) {
    using enum Verdict;
    BOOST_TEST((together(std::vector{agrees, agrees}) == agrees));
    BOOST_TEST((together(std::vector{agrees, undecided}) == undecided));
    BOOST_TEST((together(std::vector{undecided, differs, agrees}) == differs));
    BOOST_TEST((together(std::vector<Verdict>{}) == undecided)); // nothing was asked
}

BOOST_AUTO_TEST_CASE(p_value_is_worth_the_deviate_that_is_as_rare) {
    BOOST_TEST(deviate(0.05) == 1.95996398, boost::test_tools::tolerance(1e-8));
    BOOST_TEST(deviate(1) == 0);
    BOOST_TEST(std::isfinite(deviate(0)));
}

BOOST_AUTO_TEST_CASE(holm_adjusts_as_worked_by_hand) {
    // sorted 0.005, 0.011, 0.02, 0.04: times 4, 3, 2, 1, never falling
    std::vector<double> const adjusted = holm({0.02, 0.005, 0.04, 0.011});
    std::vector<double> const expected{0.04, 0.02, 0.04, 0.033};
    for (std::size_t k = 0; k < 4; ++k) BOOST_TEST(std::abs(adjusted[k] - expected[k]) < 1e-15);
    BOOST_TEST(holm({0.03, 0.02}).at(0) == 0.04); // never smaller than that of a smaller one
    BOOST_TEST(holm({0.9, 0.6}).at(1) == 1);
    BOOST_TEST(holm({}).empty());
    BOOST_TEST(holm({0.03}).at(0) == 0.03);
}

BOOST_AUTO_TEST_CASE(holm_keeps_the_false_alarms_of_a_family) {
    gsl_rng* const random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, 11);
    constexpr int families = 20'000;
    int alarms = 0;
    for (int k = 0; k < families; ++k) {
        std::vector<double> p_values(7);
        for (double& p : p_values) p = gsl_rng_uniform_pos(random);
        auto const adjusted = holm(p_values);
        alarms += *std::min_element(adjusted.begin(), adjusted.end()) < 0.05;
    }
    gsl_rng_free(random);
    double const expected = (1 - std::pow(1 - 0.05 / 7, 7)) * families; // 4.9 %
    BOOST_TEST(std::abs(alarms - expected) < 4 * std::sqrt(expected));
}

BOOST_AUTO_TEST_CASE(fisher_combines_as_worked_by_hand) {
    // two p-values: P = q (1 - ln q) with q their product
    double const q = 0.1 * 0.2;
    BOOST_TEST(std::abs(fisher({0.1, 0.2}) - q * (1 - std::log(q))) < 1e-14);
    BOOST_TEST(std::abs(fisher({0.37}) - 0.37) < 1e-14);
    BOOST_TEST(fisher({0.0, 0.5}) < 1e-250);
}
