#include "validation/harness/many_tests.hpp"

#include <boost/test/unit_test.hpp>
#include <gsl/gsl_rng.h>

#include <algorithm>
#include <cmath>

using namespace clack::validation;

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
