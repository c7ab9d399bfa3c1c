#include "validation/harness/independence.hpp"

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
