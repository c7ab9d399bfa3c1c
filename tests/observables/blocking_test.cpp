#include "observables/blocking.hpp"
#include "observables/pressure.hpp"

#include <boost/test/unit_test.hpp>

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <cmath>
#include <memory>
#include <vector>

using namespace clack;

namespace {

struct Record {
    std::vector<double> times{0}, sums{0};
};

/// Sums whose increments have mean 2 and variance 1 and keep the memory `keep` of the last one.
Record correlated_record(int count, double keep, unsigned long seed) {
    std::unique_ptr<gsl_rng, void (*)(gsl_rng*)> const rng(gsl_rng_alloc(gsl_rng_mt19937),
                                                           gsl_rng_free);
    gsl_rng_set(rng.get(), seed);
    Record record;
    double excess = gsl_ran_gaussian(rng.get(), 1);
    for (int k = 1; k <= count; ++k) {
        excess = keep * excess + std::sqrt(1 - keep * keep) * gsl_ran_gaussian(rng.get(), 1);
        record.times.push_back(k);
        record.sums.push_back(record.sums.back() + 2 + excess);
    }
    return record;
}

} // namespace

// The mean of 4096 unit normals with memory a has the standard error sqrt((1 + a)/(1 - a)/4096);
// the error of that error is 1/sqrt(2 blocks), below 18 % down to 16 blocks: 0.5 is 2.8 of those,
// and averaging 20 seeds leaves 4 %, so that 0.15 is four.
BOOST_AUTO_TEST_CASE(error_is_that_of_correlated_values) {
    for (double const keep : {0.0, 0.5, 0.9}) {
        double const expected = std::sqrt((1 + keep) / (1 - keep) / 4096);
        double mean = 0;
        for (unsigned long seed = 1; seed <= 20; ++seed) {
            auto const record = correlated_record(4096, keep, seed);
            auto const rate = rate_by_blocking(record.times, record.sums);
            BOOST_REQUIRE(rate.error);
            BOOST_TEST(std::abs(rate.value - 2) < 4 * expected);
            BOOST_TEST(std::abs(*rate.error / expected - 1) < 0.5);
            mean += *rate.error / 20;
        }
        BOOST_TEST(std::abs(mean / expected - 1) < 0.15);
    }
}

BOOST_AUTO_TEST_CASE(steady_rate_has_no_error) {
    std::vector<double> times, sums;
    for (int k = 0; k <= 100; ++k) {
        times.push_back(k * k);
        sums.push_back(3 * k * k);
    }
    auto const rate = rate_by_blocking(times, sums);
    BOOST_TEST(rate.value == 3);
    BOOST_TEST(rate.error.value() < 1e-12);
}

BOOST_AUTO_TEST_CASE(short_record_gives_a_value_without_an_error) {
    auto const record = correlated_record(block_count_min - 1, 0, 1);
    BOOST_TEST(!rate_by_blocking(record.times, record.sums).error);
    BOOST_TEST(rate_by_blocking(record.times, record.sums).value != 0);
    std::vector<double> const instant{1.0, 1.0};
    BOOST_TEST(rate_by_blocking(instant, instant).value == 0);
}

BOOST_AUTO_TEST_CASE(one_ball_between_walls_has_z_one_by_both_routes) {
    // vx = vy = vz = 3 in an accessible side of 2: each axis is hit 3 / 2 times a time with 2 m v.
    System const system{Boundary::walls, 3, 1, 1, 2};
    double const energy = 0.5 * 2 * 27;
    std::vector<Sample> samples;
    for (int k = 0; k <= 64; ++k) {
        Tallies tallies;
        tallies.wall_impulse = k * 3 * 1.5 * (2 * 2 * 3);
        samples.push_back({static_cast<double>(k), tallies, energy});
    }
    double const kt = temperature(system, energy, Eigen::Vector3d(6, 6, 6));
    BOOST_TEST(kt == 18);
    auto const z = compressibility_factor(system, kt, samples);
    BOOST_TEST(z.virial->value == 1);
    BOOST_TEST(z.wall->value == 1);
    BOOST_TEST(wall_pressure(system, samples)->value == 2.25); // N kT / l^3
}

BOOST_AUTO_TEST_CASE(no_error_is_claimed_before_anything_has_happened) {
    System const system{Boundary::walls, 30, 2, 1, 1};
    std::vector<Sample> samples;
    for (int k = 0; k <= 64; ++k) samples.push_back({static_cast<double>(k), {}, 3});
    auto const z = compressibility_factor(system, 1, samples);
    BOOST_TEST(z.virial->value == 1);
    BOOST_TEST(!z.virial->error);
    BOOST_TEST(!z.wall->error);
    BOOST_TEST(!wall_pressure(system, samples)->error);
}

BOOST_AUTO_TEST_CASE(periodic_pressure_counts_the_lost_degrees_of_freedom) {
    System const system{Boundary::periodic, 10, 5, 1, 1};
    double const kt = temperature(system, 6 + 10, Eigen::Vector3d(10, 0, 0)); // 10 of the whole
    BOOST_TEST(kt == 1);
    Tallies tallies;
    tallies.virial = 60;
    auto const z = compressibility_factor(system, kt, {{0, {}, 16}, {2, tallies, 16}});
    BOOST_TEST(z.virial->value == 1 - 1.0 / 5 + 60 / (3.0 * 5 * 2));
    BOOST_TEST(!z.wall);
    BOOST_TEST(!wall_pressure(system, {{0, {}, 16}, {2, tallies, 16}}));
    System const alone{Boundary::periodic, 10, 1, 1, 1};
    BOOST_TEST(temperature(alone, 7, Eigen::Vector3d::Zero()) == 0);
    BOOST_TEST(!compressibility_factor(alone, 0, {{0, {}, 16}, {2, tallies, 16}}).virial);
}
