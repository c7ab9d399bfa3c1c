#include "validation/statistics/estimate.hpp"

#include <boost/test/unit_test.hpp>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <cmath>
#include <stdexcept>

using namespace clack::validation;

namespace {

/// A first-order autoregressive series: its statistical inefficiency is (1 + a) / (1 - a).
std::vector<double> series_of(double const a, std::size_t const size) {
    gsl_rng* const random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, 5);
    std::vector<double> series(size);
    double x = 0;
    for (double& value : series) value = x = a * x + gsl_ran_gaussian(random, 1);
    gsl_rng_free(random);
    return series;
}

} // namespace

BOOST_AUTO_TEST_CASE(mean_and_error_are_those_computed_by_hand) {
    Estimate const estimate = mean_of({1, 2, 3, 6});
    BOOST_TEST(estimate.value == 3);
    BOOST_TEST(std::abs(estimate.error - std::sqrt(14.0 / 12)) < 1e-15);
    BOOST_TEST(estimate.degrees_of_freedom == 3);
    BOOST_CHECK_THROW(mean_of({1}), std::invalid_argument);
    std::vector<Measurement> const replicates{{1, 10}, {3, 20}};
    BOOST_TEST(mean_of(replicates, 1).value == 15);
    BOOST_CHECK_THROW(mean_of(replicates, 2), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(students_t_is_the_tables) {
    // two-sided 95 %: 12.706 for 1, 4.303 for 2, 2.262 for 9, 1.960 for infinitely many
    BOOST_TEST(std::abs(half_width({0, 1, 1}, 0.95) - 12.706) < 5e-4);
    BOOST_TEST(std::abs(half_width({0, 1, 2}, 0.95) - 4.303) < 5e-4);
    BOOST_TEST(std::abs(half_width({0, 2, 9}, 0.95) - 2 * 2.262) < 1e-3);
    BOOST_TEST(std::abs(half_width({0, 1}, 0.95) - 1.960) < 5e-4);
    BOOST_TEST(std::abs(upper_tail(2.262, 9) - 0.025) < 1e-5);
}

BOOST_AUTO_TEST_CASE(interval_holds_the_truth_as_often_as_it_says) {
    gsl_rng* const random = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(random, 7);
    constexpr int campaigns = 20'000;
    int held = 0;
    for (int k = 0; k < campaigns; ++k) {
        std::vector<double> replicates(4);
        for (double& value : replicates) value = 5 + gsl_ran_gaussian(random, 2);
        Estimate const estimate = mean_of(replicates);
        held += std::abs(estimate.value - 5) < half_width(estimate, 0.9);
    }
    gsl_rng_free(random);
    // 4 standard errors; a normal interval would hold 80 % of the time only
    BOOST_TEST(std::abs(held - 0.9 * campaigns) < 4 * std::sqrt(0.09 * campaigns));
}

BOOST_AUTO_TEST_CASE(independent_members_weigh_one_each) {
    BOOST_TEST(std::abs(statistical_inefficiency(series_of(0, 65'536)) - 1) < 0.2);
}

BOOST_AUTO_TEST_CASE(members_that_remember_weigh_less) {
    // blocks of about 100: the error of 700 blocks is known to 3 %, its square to 5 %
    BOOST_TEST(std::abs(statistical_inefficiency(series_of(0.5, 65'536)) / 3 - 1) < 0.2);
    BOOST_TEST(std::abs(statistical_inefficiency(series_of(0.9, 262'144)) / 19 - 1) < 0.2);
}

BOOST_AUTO_TEST_CASE(series_that_tells_nothing_is_refused) {
    BOOST_CHECK_THROW(statistical_inefficiency({1, 2, 3}), std::invalid_argument);
    BOOST_CHECK_THROW(statistical_inefficiency(std::vector<double>(100, 2.0)),
                      std::invalid_argument);
}
