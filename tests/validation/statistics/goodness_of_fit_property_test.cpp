#include "validation/statistics/goodness_of_fit.hpp"

#include <boost/test/unit_test.hpp>
#include <gsl/gsl_rng.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

using namespace clack::validation;

namespace {

/// Even random numbers with a fixed seed.
class Even {
public:
    explicit Even(unsigned long const seed) : random_(gsl_rng_alloc(gsl_rng_mt19937)) {
        gsl_rng_set(random_, seed);
    }
    ~Even() { gsl_rng_free(random_); }
    Even(Even const&) = delete;
    Even& operator=(Even const&) = delete;
    double operator()() { return gsl_rng_uniform_pos(random_); }
    std::vector<double> sample(std::size_t const size) {
        std::vector<double> sample(size);
        for (double& value : sample) value = (*this)();
        return sample;
    }

private:
    gsl_rng* random_;
};

std::vector<std::int64_t> counts_of(std::vector<double> const& sample, std::size_t const bins) {
    std::vector<std::int64_t> counts(bins);
    for (double const value : sample)
        ++counts[std::min(bins - 1, static_cast<std::size_t>(value * static_cast<double>(bins)))];
    return counts;
}

/// Under the law p-values are spread evenly: a tenth of them in each tenth, and one in a hundred
/// in the lowest hundredth, which is the part that verdicts live on.
void check_even(std::function<double(Even&)> const& p_value) {
    constexpr int trials = 10'000;
    Even random(2004);
    std::vector<std::int64_t> tenths(10);
    int rare = 0;
    for (int k = 0; k < trials; ++k) {
        double const p = p_value(random);
        ++tenths[std::min<std::size_t>(9, static_cast<std::size_t>(p * 10))];
        rare += p < 0.01;
    }
    BOOST_TEST(chi_square(tenths).p_value > 1e-4);
    BOOST_TEST(std::abs(rare - 0.01 * trials) < 4 * std::sqrt(0.01 * trials));
}

} // namespace

BOOST_AUTO_TEST_CASE(kolmogorovs_limit_law_has_its_tabulated_quantiles) {
    // N. Smirnov, Ann. Math. Statist. 19, 279 (1948): 1.2238, 1.3581, 1.6276
    BOOST_TEST(std::abs(kolmogorov_limit(1.2238) - 0.90) < 1e-4);
    BOOST_TEST(std::abs(kolmogorov_limit(1.3581) - 0.95) < 1e-4);
    BOOST_TEST(std::abs(kolmogorov_limit(1.6276) - 0.99) < 1e-4);
    BOOST_TEST(std::abs(kolmogorov_limit(0.9999999) - kolmogorov_limit(1)) < 1e-6); // seam
    BOOST_TEST(kolmogorov_limit(0) == 0);
    BOOST_TEST(kolmogorov_limit(0.2) < 1e-12);
    BOOST_TEST(std::abs(kolmogorov_limit(4) - 1) < 1e-13);
}

BOOST_AUTO_TEST_CASE(kolmogorov_smirnov_is_right_for_ten_members) {
    // Exact probability that the distance of ten stays below 0.274: 0.6284796154565
    // (G. Marsaglia, W. W. Tsang, J. Wang, J. Statist. Software 8(18) (2003)).
    std::vector<double> sample;
    for (int k = 0; k < 10; ++k) sample.push_back((k + 1) / 10.0);
    for (double& value : sample) value = std::min(1.0, value - 0.1 + 0.274);
    Test const test = kolmogorov_smirnov(sample);
    BOOST_TEST(std::abs(test.statistic - 0.274) < 1e-14);
    BOOST_TEST(std::abs(test.p_value - (1 - 0.6284796154565)) < 3e-3);
}

BOOST_AUTO_TEST_CASE(kolmogorov_smirnov_finds_the_largest_distance_on_either_side) {
    BOOST_TEST(std::abs(kolmogorov_smirnov({0.9}).statistic - 0.9) < 1e-15);
    BOOST_TEST(std::abs(kolmogorov_smirnov({0.1}).statistic - 0.9) < 1e-15);
    BOOST_TEST(std::abs(kolmogorov_smirnov({0.6, 0.2}).statistic - 0.4) < 1e-15);
    BOOST_CHECK_THROW(kolmogorov_smirnov({}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(anderson_darlings_limit_law_has_its_known_moments) {
    // The limit is a sum of chi-squares over j (j + 1): mean 1, variance 2 (pi^2 - 9) / 3.
    double mean = 0, square = 0;
    double const step = 1e-3;
    for (int k = 0; k < 60'000; ++k) {
        double const z = (k + 0.5) * step;
        double const beyond = 1 - anderson_darling_limit(z);
        mean += beyond * step;
        square += 2 * z * beyond * step;
    }
    double const variance = 2 * (std::numbers::pi * std::numbers::pi - 9) / 3;
    BOOST_TEST(std::abs(mean - 1) < 1e-6);
    BOOST_TEST(std::abs(square - 1 - variance) < 1e-6);
}

BOOST_AUTO_TEST_CASE(anderson_darlings_limit_law_has_its_tabulated_quantiles) {
    BOOST_TEST(std::abs(anderson_darling_limit(1.933) - 0.90) < 1e-4);
    BOOST_TEST(std::abs(anderson_darling_limit(2.492) - 0.95) < 1e-4);
    BOOST_TEST(anderson_darling_limit(0) == 0);
    BOOST_TEST(anderson_darling_limit(0.02) < 1e-20);
    BOOST_TEST(std::abs(anderson_darling_limit(100) - 1) < 1e-11);
}

BOOST_AUTO_TEST_CASE(anderson_darlings_statistic_is_that_worked_by_hand) {
    // one member: A^2 = -1 - ln u - ln(1 - u)
    BOOST_TEST(std::abs(anderson_darling({0.3}).statistic - (-1 - std::log(0.3) - std::log(0.7))) <
               1e-15);
    double const two =
        -2 - (std::log(0.2) + std::log(1 - 0.6) + 3 * (std::log(0.6) + std::log(0.8))) / 2;
    BOOST_TEST(std::abs(anderson_darling({0.6, 0.2}).statistic - two) < 1e-15);
    BOOST_TEST(anderson_darling({0.5, 1.0, 0.2}).p_value < 1e-3); // the law excludes it
    BOOST_CHECK_THROW(anderson_darling({}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(chi_square_is_that_worked_by_hand) {
    Test const test = chi_square({5, 15, 10});
    BOOST_TEST(test.statistic == 5);
    BOOST_TEST(std::abs(test.p_value - std::exp(-2.5)) < 1e-14); // two degrees of freedom
    // bins of a half, a third and a sixth: (3^2 / 15 + 5^2 / 10 + 2^2 / 5)
    Test const uneven = chi_square({18, 5, 7}, {1.0 / 2, 1.0 / 3, 1.0 / 6});
    BOOST_TEST(std::abs(uneven.statistic - (0.6 + 2.5 + 0.8)) < 1e-14);
    BOOST_CHECK_THROW(chi_square({18, 5, 7}, {0.5, 0.5}), std::invalid_argument);
    BOOST_CHECK_THROW(chi_square({7}), std::invalid_argument);
    BOOST_CHECK_THROW(chi_square({0, 0}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(kolmogorov_smirnov_p_values_are_even_under_the_law) {
    check_even([](Even& random) { return kolmogorov_smirnov(random.sample(10)).p_value; });
    check_even([](Even& random) { return kolmogorov_smirnov(random.sample(80)).p_value; });
}

BOOST_AUTO_TEST_CASE(anderson_darling_p_values_are_even_under_the_law) {
    check_even([](Even& random) { return anderson_darling(random.sample(8)).p_value; });
    check_even([](Even& random) { return anderson_darling(random.sample(40)).p_value; });
}

BOOST_AUTO_TEST_CASE(chi_square_p_values_are_even_under_the_law) {
    check_even([](Even& random) { return chi_square(counts_of(random.sample(400), 8)).p_value; });
}

BOOST_AUTO_TEST_CASE(every_test_refuses_another_law) {
    Even random(1);
    std::vector<double> skewed = random.sample(20'000);
    for (double& value : skewed) value = std::pow(value, 1.03); // largest distance 1.1 %
    BOOST_TEST(kolmogorov_smirnov(skewed).p_value < 0.05);
    BOOST_TEST(anderson_darling(skewed).p_value < 0.05);
    BOOST_TEST(chi_square(counts_of(skewed, 20)).p_value < 0.05);
}
