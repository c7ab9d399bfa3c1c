#include "view/physics.hpp"

#include "reference/finite_size.hpp"
#include "reference/velocity_laws.hpp"
#include "reference/walled_fluid.hpp"
#include "view/confinement.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace clack::view {

namespace {

using reference::MaxwellBoltzmann;
using reference::VelocityLaw;

std::optional<VelocityLaw> law_of(Frame const& frame) {
    try {
        return VelocityLaw(frame.system, frame.sample.kinetic_energy);
    } catch (std::invalid_argument const&) { // too few balls
        return std::nullopt;
    }
}

std::vector<double> speeds_of(Frame const& frame) {
    std::vector<double> speeds(static_cast<std::size_t>(frame.system.count));
    for (Eigen::Index ball = 0; ball < frame.system.count; ++ball)
        speeds[static_cast<std::size_t>(ball)] = frame.snapshot.velocities.col(ball).norm();
    return speeds;
}

std::optional<SpeedTest> test_speeds(std::vector<double> const& speeds, VelocityLaw const& law) {
    constexpr std::size_t balls_in_class_min = 5, classes_min = 4, classes_max = 32;
    auto const classes = std::min(speeds.size() / balls_in_class_min, classes_max);
    if (classes < classes_min) return std::nullopt;
    std::vector<double> edges;
    for (std::size_t k = 1; k < classes; ++k)
        edges.push_back(law.speed_quantile(static_cast<double>(k) / static_cast<double>(classes)));
    std::vector<double> counts(classes, 0);
    for (double const speed : speeds) {
        auto const edge = std::upper_bound(edges.begin(), edges.end(), speed);
        ++counts[static_cast<std::size_t>(edge - edges.begin())];
    }
    double const expected = static_cast<double>(speeds.size()) / static_cast<double>(classes);
    SpeedTest test;
    for (double const count : counts)
        test.chi_square += (count - expected) * (count - expected) / expected;
    test.degrees_of_freedom = static_cast<int>(classes) - 1;
    test.p_value = gsl_cdf_chisq_Q(test.chi_square, test.degrees_of_freedom);
    return test;
}

SpeedHistogram histogram_of(std::vector<double> const& speeds, double top) {
    constexpr std::size_t classes_max = 30;
    SpeedHistogram histogram;
    histogram.top = top;
    auto const classes = std::clamp<std::size_t>(speeds.size() / 8, 8, classes_max);
    histogram.measured.assign(classes, 0);
    double const width = histogram.top / static_cast<double>(classes);
    auto const share = static_cast<float>(1 / (static_cast<double>(speeds.size()) * width));
    for (double const speed : speeds) {
        if (speed < histogram.top)
            histogram.measured[static_cast<std::size_t>(speed / width)] += share;
        else
            ++histogram.beyond;
    }
    return histogram;
}

void add_laws(SpeedHistogram& histogram, std::optional<VelocityLaw> const& law, double kt,
              double mass) {
    constexpr std::size_t points = 81;
    MaxwellBoltzmann const maxwell(kt, mass);
    for (std::size_t k = 0; k < points; ++k) {
        double const speed = histogram.top * static_cast<double>(k) / (points - 1);
        histogram.maxwell.push_back(static_cast<float>(maxwell.speed_density(speed)));
        if (law) histogram.exact.push_back(static_cast<float>(law->speed_density(speed)));
    }
}

/// With the laws that they follow in space.
void add_speeds(Physics& physics, Frame const& frame) {
    auto const speeds = speeds_of(frame);
    if (!physics.without_law.empty()) {
        physics.speeds =
            histogram_of(speeds, 1.25 * *std::max_element(speeds.begin(), speeds.end()));
        return;
    }
    double const kt = physics.temperature, mass = frame.system.mass;
    physics.speeds = histogram_of(speeds, 4 * std::sqrt(kt / mass));
    auto const law = law_of(frame);
    add_laws(physics.speeds, law, kt, mass);
    if (law) physics.speed_test = test_speeds(speeds, *law);
}

/// Where nothing has collided there is nothing to tell.
CompressibilityFactor factor_of(System const& system, double kt,
                                std::vector<Sample> const& samples) {
    auto factor = compressibility_factor(system, kt, samples);
    if (samples.empty() || samples.back().tallies.virial == 0) factor.virial.reset();
    if (samples.empty() || samples.back().tallies.wall_impulse == 0) factor.wall.reset();
    return factor;
}

/// At times that lie evenly, as the samples do.
std::vector<PressurePoint> course_of(System const& system, double kt,
                                     std::vector<Sample> const& samples) {
    constexpr std::size_t points_max = 48;
    std::vector<PressurePoint> course;
    std::vector<Sample> until;
    std::size_t const points = std::min(points_max, samples.size());
    for (std::size_t point = 1; point <= points; ++point) {
        auto const end = static_cast<std::ptrdiff_t>(point * samples.size() / points);
        until.assign(samples.begin(), samples.begin() + end);
        if (until.back().time > until.front().time)
            course.push_back({until.back().time, factor_of(system, kt, until)});
    }
    return course;
}

void add_theory(Physics& physics, System const& system) {
    constexpr std::int64_t balls_min = 16; // fewer, as a cradle's, are no fluid
    if (system.count < balls_min) return;
    try {
        double const side = system.side / system.diameter;
        auto const count = static_cast<double>(system.count);
        if (system.boundary == Boundary::periodic) {
            double const z =
                reference::periodic_compressibility(count / (side * side * side), system.count);
            constexpr double left_out = 1; // terms of order 1 / N^2, and images
            physics.theory = Estimate{z, z * left_out / (count * count) + 2e-5 * z};
        } else {
            double const z = reference::walled_compressibility(side, count);
            constexpr double left_out = 2.5; // edges: at most so much of 1 / side^2
            physics.theory = Estimate{z, z * left_out / (side * side)};
        }
    } catch (std::invalid_argument const&) { // not a fluid, or too few balls for one
    }
}

} // namespace

Physics physics_of(Frame const& frame, std::vector<Sample> const& samples) {
    Physics physics;
    double const energy = frame.sample.kinetic_energy;
    Eigen::Vector3d const momentum = frame.system.mass * frame.snapshot.velocities.rowwise().sum();
    physics.temperature = temperature(frame.system, energy, momentum);
    if (!samples.empty() && samples.front().kinetic_energy > 0)
        physics.energy_drift = energy / samples.front().kinetic_energy - 1;
    if (!(physics.temperature > 0)) return physics;
    physics.directions = directions_of_motion(frame.system, frame.snapshot);
    physics.without_law = why_without_law(frame.system.count, physics.directions);
    add_speeds(physics, frame);
    if (physics.directions < 3) return physics;
    physics.compressibility_factor = factor_of(frame.system, physics.temperature, samples);
    physics.course = course_of(frame.system, physics.temperature, samples);
    add_theory(physics, frame.system);
    return physics;
}

Range range_of(Physics const& physics) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Range range{infinite, -infinite};
    auto const take_in = [&](std::optional<Estimate> const& estimate) {
        if (!estimate) return;
        range.low = std::min(range.low, estimate->value - estimate->error.value_or(0));
        range.high = std::max(range.high, estimate->value + estimate->error.value_or(0));
    };
    take_in(physics.theory);
    for (std::size_t k = physics.course.size() / 4; k < physics.course.size(); ++k) {
        take_in(physics.course[k].factor.virial);
        take_in(physics.course[k].factor.wall);
    }
    if (!(range.low <= range.high)) return {0, 1};
    double const margin =
        std::max(0.1 * (range.high - range.low), 1e-3 * std::max(std::abs(range.high), 1e-300));
    return {range.low - margin, range.high + margin};
}

} // namespace clack::view
