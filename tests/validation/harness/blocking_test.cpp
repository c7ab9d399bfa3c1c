#include "validation/harness/blocking.hpp"

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

BOOST_AUTO_TEST_CASE(independent_series_has_the_simple_error) {
    BOOST_TEST(std::abs(statistical_inefficiency(series_of(0, 65'536)) - 1) < 0.15);
}

BOOST_AUTO_TEST_CASE(correlated_series_has_the_larger_error) {
    // blocks of about 100: 700 blocks know their variance to 5 %, the rest is the blocks' overlap
    BOOST_TEST(std::abs(statistical_inefficiency(series_of(0.5, 65'536)) / 3 - 1) < 0.15);
    BOOST_TEST(std::abs(statistical_inefficiency(series_of(0.9, 262'144)) / 19 - 1) < 0.2);
}

BOOST_AUTO_TEST_CASE(mean_is_that_of_all_members) {
    std::vector<double> series = series_of(0.5, 1001);
    double const mean = mean_of(series).value;
    BOOST_TEST(mean_of_series(series).value == mean);
    BOOST_TEST(mean_of_series({2, 2, 2, 2, 2}).error == 0);
    BOOST_CHECK_THROW(mean_of_series({1, 2, 3}), std::invalid_argument);
}
