#pragma once
// How fast the balls are: state points, one measurement, and what it should give.

#include "reference/velocity_laws.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/mutants/engine_maker.hpp"
#include "validation/statistics/estimate.hpp"
#include "validation/statistics/goodness_of_fit.hpp"
#include "validation/statistics/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace clack::validation::velocity_distribution {

/// Balls that all start with one speed in a cube with walls, looked at again and again.
struct StatePoint {
    std::int64_t count;
    double packing_fraction;
    double equilibration; // collisions per ball before the first look
    double spacing;       // collisions per ball from look to look
    int looks;            // of one replicate
    int replicates;

    std::string text() const {
        return fmt::format("count={} packing_fraction={} equilibration={} spacing={} looks={}",
                           count, packing_fraction, equilibration, spacing, looks);
    }
};

/// Few balls, whose exact law is visibly not Maxwell and Boltzmann's, and more, whose law nearly
/// is. After 5 collisions a ball has forgotten its speed.
inline std::vector<StatePoint> state_points(Profile const profile) {
    int const longer = profile == Profile::quick ? 1 : 20;
    return {{8, 0.1, 50, 5, 50'000 * longer, 16},
            {32, 0.1, 50, 5, 6'000 * longer, 16},
            {128, 0.1, 50, 5, 1'500 * longer, 16}};
}

/// Bins of speed, in units of sqrt(kT/m): the last takes all that is faster.
constexpr std::size_t bin_count = 35;
constexpr double bin_width = 0.1;

/// What one replicate measures.
struct Sample {
    double fourth_moment = 0;  // <v^4> / <v^2>^2 over all balls and looks
    double kolmogorov_smirnov; // p-values of the speeds of one ball a look
    double anderson_darling;
    double inefficiency; // of the same: 1 where they are independent
    double spacing;      // collisions per ball from look to look, as they came
    std::vector<std::int64_t> counts = std::vector<std::int64_t>(bin_count);

    Measurement as_measurement() const {
        Measurement values{fourth_moment, kolmogorov_smirnov, anderson_darling, inefficiency,
                           spacing};
        for (std::int64_t const count : counts) values.push_back(static_cast<double>(count));
        return values;
    }
    explicit Sample(Measurement const& values)
        : fourth_moment(values.at(0)), kolmogorov_smirnov(values.at(1)),
          anderson_darling(values.at(2)), inefficiency(values.at(3)), spacing(values.at(4)) {
        for (std::size_t k = 0; k < bin_count; ++k)
            counts[k] = static_cast<std::int64_t>(values.at(5 + k));
    }
    Sample() = default;
};

inline Scene scene_of(std::int64_t const count, double const packing_fraction,
                      std::uint64_t const seed) {
    Scene scene;
    scene.system.boundary = Boundary::walls;
    scene.system.count = count;
    scene.system.side =
        std::cbrt(static_cast<double>(count) * std::numbers::pi / 6 / packing_fraction);
    scene.arrangement = Arrangement::random;
    scene.distribution = Distribution::equal_speed;
    scene.seed = seed;
    return scene;
}

/// Sum of v^4 over the sum of v^2 squared, times the number of balls.
inline double fourth_moment_of(Eigen::Matrix3Xd const& velocities) {
    auto const squares = velocities.colwise().squaredNorm();
    return squares.array().square().mean() / std::pow(squares.mean(), 2);
}

/// Runs on until the balls have had about so many collisions each, and returns the time between two
/// of one ball. Times are fixed rather than counts from then on: a look at the moment of a
/// collision would see fast balls too often.
inline double equilibrate(Engine& engine, double const collisions_per_ball) {
    auto const pairs = static_cast<double>(engine.system().count) / 2;
    engine.advance(
        {.ball_collisions = static_cast<std::uint64_t>(std::ceil(collisions_per_ball * pairs))});
    double const free_time =
        engine.time() * pairs / static_cast<double>(engine.tallies().ball_collisions);
    engine.start_clock();
    return free_time;
}

/// Looks at all balls for the fourth moment, and at one, each in turn, for the tests: the speeds of
/// several balls at one moment share one energy and are not independent.
inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(scene_of(point.count, point.packing_fraction, seed));
    reference::VelocityLaw const law(engine->system(), engine->kinetic_energy());
    double const wait = point.spacing * equilibrate(*engine, point.equilibration);

    Sample sample;
    std::vector<double> probabilities;
    for (int look = 1; look <= point.looks; ++look) {
        engine->advance({.time = look * wait});
        Snapshot const shot = engine->snapshot();
        sample.fourth_moment += fourth_moment_of(shot.velocities) / point.looks;
        double const speed = shot.velocities.col(look % point.count).norm();
        probabilities.push_back(law.speed_probability(speed));
        ++sample.counts[std::min(bin_count - 1, static_cast<std::size_t>(speed / bin_width))];
    }
    sample.kolmogorov_smirnov = kolmogorov_smirnov(probabilities).p_value;
    sample.anderson_darling = anderson_darling(probabilities).p_value;
    sample.inefficiency = statistical_inefficiency(probabilities);
    sample.spacing = 2 * static_cast<double>(engine->tallies().ball_collisions) /
                     static_cast<double>(point.count) / point.looks;
    return sample.as_measurement();
}

/// How many speeds of all replicates lie in each bin.
inline std::vector<std::int64_t> counts_of(std::vector<Measurement> const& replicates) {
    std::vector<std::int64_t> counts(bin_count);
    for (Measurement const& measurement : replicates)
        for (std::size_t k = 0; k < bin_count; ++k) counts[k] += Sample(measurement).counts[k];
    return counts;
}

/// Probabilities of the bins under a law of velocities.
template <class Law> std::vector<double> bin_probabilities(Law const& law) {
    std::vector<double> probabilities;
    double below = 0;
    for (std::size_t k = 1; k <= bin_count; ++k) {
        double const up_to =
            k == bin_count ? 1 : law.speed_probability(static_cast<double>(k) * bin_width);
        probabilities.push_back(up_to - below);
        below = up_to;
    }
    return probabilities;
}

/// The law for a point's balls when kT = 1.
inline reference::VelocityLaw law_of(StatePoint const& point) {
    System const system = scene_of(point.count, point.packing_fraction, 0).system;
    return {system, system.degrees_of_freedom() / 2};
}

/// What all replicates of a point say: the fourth moment, and three tests of fit. The moment's
/// margin is half its distance from Maxwell and Boltzmann's 5/3, so that one that agrees cannot be
/// theirs.
inline void enter(Ledger& ledger, StatePoint const& point,
                  std::vector<Measurement> const& replicates) {
    std::vector<std::string> const state{cell(point.count)};
    std::vector<double> distances, tails;
    for (Measurement const& measurement : replicates) {
        distances.push_back(Sample(measurement).kolmogorov_smirnov);
        tails.push_back(Sample(measurement).anderson_darling);
    }
    double const theory = law_of(point).fourth_moment_ratio();
    ledger.compare(state, {"fourth_moment", "$\\langle v^4\\rangle/\\langle v^2\\rangle^2$"},
                   {.measured = mean_of(replicates, std::size_t{0}),
                    .reference = theory,
                    .margin = (reference::MaxwellBoltzmann::fourth_moment_ratio - theory) / 2});
    ledger.fit(state, {"chi_square", "speeds, $\\chi^2$"},
               chi_square(counts_of(replicates), bin_probabilities(law_of(point))).p_value);
    ledger.fit(state, {"kolmogorov_smirnov", "speeds, KS"}, fisher(distances));
    ledger.fit(state, {"anderson_darling", "speeds, AD"}, fisher(tails));
}

} // namespace clack::validation::velocity_distribution
