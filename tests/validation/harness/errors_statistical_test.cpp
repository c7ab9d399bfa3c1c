// Are errors as large as they say, and does a shift show? Each check on random numbers goes wrong
// with a probability of 2e-4 for another seed.

#include "observables/blocking.hpp"
#include "validation/periodic_run.hpp"
#include "validation/records/campaign.hpp"
#include "validation/tools/regression.hpp"

#include <gsl/gsl_cdf.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

using namespace clack;
using namespace clack::validation;

namespace {

/// Whether so many of so many intervals may have held the truth if each does with 95 %.
bool may_cover_95_percent(unsigned const covered, unsigned const all) {
    BOOST_TEST_MESSAGE(covered << " of " << all << " intervals hold the truth");
    return gsl_cdf_binomial_P(covered, 0.95, all) > 1e-4 &&
           (covered == 0 || gsl_cdf_binomial_Q(covered - 1, 0.95, all) > 1e-4);
}

bool holds(validation::Estimate const& estimate, double const truth) {
    return std::abs(estimate.value - truth) < half_width(estimate, 0.95);
}

/// A mean with the error that blocking finds.
validation::Estimate blocked(std::vector<double> const& series) {
    std::vector<double> times{0}, sums{0};
    for (double const value : series) {
        times.push_back(times.back() + 1);
        sums.push_back(sums.back() + value);
    }
    auto const found = rate_by_blocking(times, sums);
    return {found.value, found.error.value()};
}

} // namespace

BOOST_AUTO_TEST_CASE(students_intervals_cover_what_they_say) {
    std::mt19937_64 random(1);
    std::normal_distribution<> normal;
    unsigned covered = 0;
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<double> values(16);
        for (double& value : values) value = 3 + normal(random);
        covered += holds(mean_of(values), 3);
    }
    BOOST_TEST(may_cover_95_percent(covered, 200));
}

// Series that remember: each member is 0.9 of the one before and a fresh deviate.
BOOST_AUTO_TEST_CASE(blocked_intervals_of_correlated_series_cover_what_they_say) {
    std::mt19937_64 random(2);
    std::normal_distribution<> normal;
    unsigned covered = 0, if_independent = 0;
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<double> series(8192);
        double value = normal(random) / std::sqrt(1 - 0.81);
        for (double& member : series) member = 3 + (value = 0.9 * value + normal(random));
        covered += holds(blocked(series), 3);
        if_independent += holds(mean_of(series), 3);
    }
    BOOST_TEST(may_cover_95_percent(covered, 200));
    BOOST_TEST(!may_cover_95_percent(if_independent, 200));
}

BOOST_AUTO_TEST_CASE(blocked_intervals_of_real_runs_cover_what_they_say) {
    PeriodicRun const run{{0.2, 108}, 30, 500};
    double const truth = run.expected();
    unsigned covered = 0, students = 0;
    std::vector<double> values;
    for (int replicate = 0; replicate < 100; ++replicate) {
        auto const engine = make_true_engine(run.scene(seed_of("coverage", run.text(), replicate)));
        auto const measured = run_periodic(run, *engine);
        covered += holds({measured.by_virial, measured.virial_error}, truth);
        values.push_back(measured.by_virial);
        if (values.size() == 5) {
            students += holds(mean_of(values), truth);
            values.clear();
        }
    }
    BOOST_TEST(may_cover_95_percent(covered, 100));
    BOOST_TEST(may_cover_95_percent(students, 20));
}

BOOST_AUTO_TEST_CASE(shift_of_one_value_among_many_shows) {
    std::mt19937_64 random(3);
    std::normal_distribution<> normal;
    std::vector<Known> before, now;
    for (int place = 0; place < 100; ++place) {
        before.push_back({"demo", "x=1", place, normal(random), 1, 16, "1"});
        now.push_back({"demo", "x=1", place, normal(random), 1, 16, "2"});
    }
    BOOST_TEST(shifts(before, now).front().p > regression_false_alarm);
    now[42].mean += 15;
    auto const all = shifts(before, now);
    BOOST_TEST(all.front().now.place == 42);
    BOOST_TEST(all.front().p < regression_false_alarm);
    BOOST_TEST(all[1].p > regression_false_alarm);
}

BOOST_AUTO_TEST_CASE(value_without_scatter_shifts_when_it_differs) {
    Known const known{"demo", "x=1", 0, 2, 0, 16, "1"};
    Known other = known;
    BOOST_TEST(shifts({known}, {other}).front().p == 1);
    other.mean += 1e-15;
    BOOST_TEST(shifts({known}, {other}).front().p == 0);
    other.state_point = "x=2";
    BOOST_TEST(shifts({known}, {other}).empty());
}

BOOST_AUTO_TEST_CASE(value_of_one_side_only_is_missing_from_the_other) {
    Known const known{"demo", "x=1", 0, 2, 0, 16, "1"};
    Known other = known;
    other.place = 1;
    BOOST_TEST(missing_from({known}, {known}).empty());
    auto const missing = missing_from({known}, {known, other});
    BOOST_REQUIRE(missing.size() == 1);
    BOOST_TEST(missing.front().place == 1);
}
