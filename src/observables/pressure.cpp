#include "observables/pressure.hpp"

namespace clack {

namespace {

/// Rate of one tally over the samples. While nothing has happened yet all blocks agree, which says
/// nothing about how far off they are: there is no error.
Estimate tally_rate(std::vector<Sample> const& samples, double Tallies::*tally) {
    std::vector<double> times, sums;
    for (auto const& sample : samples) {
        times.push_back(sample.time);
        sums.push_back(sample.tallies.*tally);
    }
    Estimate rate = rate_by_blocking(times, sums);
    if (!sums.empty() && sums.back() == sums.front()) rate.error.reset();
    return rate;
}

Estimate scaled(Estimate estimate, double factor, double shift = 0) {
    estimate.value = shift + factor * estimate.value;
    if (estimate.error) *estimate.error *= factor;
    return estimate;
}

} // namespace

double temperature(System const& system, double kinetic_energy, Eigen::Vector3d const& momentum) {
    auto const count = static_cast<double>(system.count);
    if (system.boundary == Boundary::walls) return 2 * kinetic_energy / (3 * count);
    if (system.count < 2) return 0;
    double const of_the_whole = momentum.squaredNorm() / (2 * system.mass * count);
    return 2 * (kinetic_energy - of_the_whole) / (3 * count - 3);
}

CompressibilityFactor compressibility_factor(System const& system, double kt,
                                             std::vector<Sample> const& samples) {
    CompressibilityFactor factor;
    if (!(kt > 0) || samples.empty() || !(samples.back().time > samples.front().time)) {
        return factor;
    }
    auto const count = static_cast<double>(system.count);
    bool const periodic = system.boundary == Boundary::periodic;
    double const ideal = periodic ? 1 - 1 / count : 1;
    factor.virial = scaled(tally_rate(samples, &Tallies::virial), 1 / (3 * count * kt), ideal);
    if (auto const pressure = wall_pressure(system, samples)) {
        double const side = system.accessible_side();
        factor.wall = scaled(*pressure, side * side * side / (count * kt));
    }
    return factor;
}

std::optional<Estimate> wall_pressure(System const& system, std::vector<Sample> const& samples) {
    if (system.boundary == Boundary::periodic || samples.empty() ||
        !(samples.back().time > samples.front().time)) {
        return std::nullopt;
    }
    double const side = system.accessible_side();
    return scaled(tally_rate(samples, &Tallies::wall_impulse), 1 / (6 * side * side));
}

} // namespace clack
