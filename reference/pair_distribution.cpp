#include "reference/pair_distribution.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

namespace clack::reference {

namespace {

constexpr int steps_per_diameter = 400;

/// Baxter's factor q(r) = a/2 (r^2 - 1) + b (r - 1) within the diameter, 0 beyond.
struct Baxter {
    double a, b;

    explicit Baxter(double const eta)
        : a((1 + 2 * eta) / ((1 - eta) * (1 - eta))), b(-1.5 * eta / ((1 - eta) * (1 - eta))) {}
    double operator()(double const r) const { return a / 2 * (r * r - 1) + b * (r - 1); }
    double slope(double const r) const { return a * r + b; }
};

double mended_packing_fraction(double const eta) { return eta - eta * eta / 16; }

} // namespace

/// Marches H(r) = r (g(r) - 1) by H(r) = 12 eta int_0^1 q(t) (r - t) h(|r - t|) dt for r > 1, with
/// h = -1 within the diameter, by the trapezoidal rule. q(1) = 0, and where r - t passes 1, H jumps
/// from -1 to its contact value: there the mean of both counts.
PercusYevick::PercusYevick(double const packing_fraction, double const reach)
    : packing_fraction_(packing_fraction), reach_(reach) {
    if (!(packing_fraction > 0 && packing_fraction < 0.6 && reach >= 1 && reach <= 100)) {
        throw std::invalid_argument(fmt::format("packing_fraction = {}, reach = {}: Percus and "
                                                "Yevick's g is given in (0, 0.6), [1, 100]",
                                                packing_fraction, reach));
    }
    Baxter const q(packing_fraction);
    constexpr int n = steps_per_diameter;
    constexpr double step = 1.0 / n;
    double const weight = 12 * packing_fraction * step;
    auto const last = static_cast<int>(std::ceil(reach * n)) + 1;
    int const points = last - n + 1;
    values_.reserve(static_cast<std::size_t>(points));
    for (int i = n; i <= last; ++i) {
        double sum = 0;
        for (int t = 1; t <= n; ++t) {
            int const k = i - t; // r - t in steps
            double const inside = -step * k;
            double const value = k < n   ? inside
                                 : k > n ? values_[static_cast<std::size_t>(k - n)]
                                         : (inside + values_.front()) / 2;
            sum += q(step * t) * value;
        }
        // t = 0 counts half, and its H(r) is the one that is sought. At contact it is the end of a
        // stretch within the diameter.
        double const own = q(0) * weight / 2;
        values_.push_back(i == n ? weight * sum - own : weight * sum / (1 - own));
    }
}

double PercusYevick::radial_distribution(double const distance) const {
    if (distance < 1) return 0;
    if (!(distance <= reach_))
        throw std::invalid_argument(fmt::format("distance = {}: beyond the reach", distance));
    double const place = (distance - 1) * steps_per_diameter;
    auto const below = static_cast<std::size_t>(place);
    double const part = place - static_cast<double>(below);
    return 1 + ((1 - part) * values_[below] + part * values_[below + 1]) / distance;
}

/// 1 / S = |1 - 12 eta int_0^1 q(r) exp(i k r) dr|^2, by Simpson's rule.
double PercusYevick::structure_factor(double const wave_number) const {
    Baxter const q(packing_fraction_);
    constexpr int n = steps_per_diameter;
    std::complex<double> integral = q(0);
    for (int i = 1; i < n; ++i) { // q(1) = 0
        double const r = static_cast<double>(i) / n;
        integral += (i % 2 == 1 ? 4 : 2) * q(r) * std::polar(1.0, wave_number * r);
    }
    return 1 / std::norm(1.0 - 12 * packing_fraction_ * integral / (3.0 * n));
}

VerletWeis::VerletWeis(double const packing_fraction, double const contact_value,
                       double const reach)
    : width_(std::cbrt(mended_packing_fraction(packing_fraction) / packing_fraction)),
      closure_(mended_packing_fraction(packing_fraction), reach / width_),
      amplitude_(contact_value - closure_.radial_distribution(1 / width_)),
      wave_number_(24 * amplitude_ /
                   (mended_packing_fraction(packing_fraction) * closure_.radial_distribution(1))) {}

double VerletWeis::radial_distribution(double const distance) const {
    if (distance < 1) return 0;
    double const beyond = wave_number_ * (distance - 1);
    return closure_.radial_distribution(distance / width_) +
           amplitude_ / distance * std::exp(-beyond) * std::cos(beyond);
}

} // namespace clack::reference
