#include "validation/statistics/goodness_of_fit.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace clack::validation {

namespace {

void require_sample(std::vector<double> const& probabilities) {
    if (probabilities.empty()) throw std::invalid_argument("a test takes a sample");
}

/// What a finite sample adds to the limit law's probability x of A^2 (Marsaglia and Marsaglia's
/// fits in their three ranges of x).
double anderson_darling_correction(double const size, double const x) {
    if (x > 0.8) {
        double const g =
            -130.2137 +
            (745.2337 - (1705.091 - (1950.646 - (1116.360 - 255.7844 * x) * x) * x) * x) * x;
        return g / size;
    }
    double const middle = 0.01265 + 0.1757 / size;
    if (x < middle) {
        double const v = x / middle;
        double const g = std::sqrt(v) * (1 - v) * (49 * v - 102);
        return g * (0.0037 / (size * size) + 0.00078 / size + 0.00006) / size;
    }
    double const v = (x - middle) / (0.8 - middle);
    double const g =
        -0.00022633 + (6.54034 - (14.6538 - (14.458 - (8.259 - 1.91864 * v) * v) * v) * v) * v;
    return g * (0.04213 + 0.01365 / size) / size;
}

} // namespace

Test chi_square(std::vector<std::int64_t> const& counts, std::vector<double> const& probabilities) {
    auto const total =
        static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}));
    if (counts.size() < 2 || counts.size() != probabilities.size() || total <= 0)
        throw std::invalid_argument("chi-square takes two bins, a probability each, and a count");
    double sum = 0;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        double const expected = total * probabilities[k];
        double const excess = static_cast<double>(counts[k]) - expected;
        sum += excess * excess / expected;
    }
    return {sum, gsl_cdf_chisq_Q(sum, static_cast<double>(counts.size()) - 1)};
}

Test chi_square(std::vector<std::int64_t> const& counts) {
    return chi_square(counts,
                      std::vector<double>(counts.size(), 1 / static_cast<double>(counts.size())));
}

double kolmogorov_limit(double const x) {
    if (x <= 0) return 0;
    double sum = 0;
    if (x < 1) { // few terms are needed of either series on its side
        for (int k = 1; k <= 9; k += 2)
            sum += std::exp(-k * k * std::numbers::pi * std::numbers::pi / (8 * x * x));
        return std::sqrt(2 * std::numbers::pi) / x * sum;
    }
    for (int k = 1; k <= 5; ++k) sum += (k % 2 ? 1 : -1) * std::exp(-2.0 * k * k * x * x);
    return 1 - 2 * sum;
}

Test kolmogorov_smirnov(std::vector<double> probabilities) {
    require_sample(probabilities);
    std::sort(probabilities.begin(), probabilities.end());
    auto const size = static_cast<double>(probabilities.size());
    double distance = 0;
    double below = 0;
    for (double const probability : probabilities) {
        distance =
            std::max({distance, probability - below / size, (below + 1) / size - probability});
        ++below;
    }
    double const x = std::sqrt(size) * distance;
    double const corrected = x + 1 / (6 * std::sqrt(size)) + (x - 1) / (4 * size);
    return {distance, std::clamp(1 - kolmogorov_limit(corrected), 0.0, 1.0)};
}

double anderson_darling_limit(double const z) {
    if (z <= 0) return 0;
    constexpr double negligible = 40; // exp(-40) is below a rounding
    constexpr double step = 0.1;      // trapezoids: error exp(-2 pi / step), the poles being at +-i
    double sum = 0, coefficient = 1;  // binomial(-1/2, j)
    for (int j = 0;; ++j) {
        double const odd = 4 * j + 1;
        double const t = odd * odd * std::numbers::pi * std::numbers::pi / (8 * z);
        if (t - z / 8 > negligible) break;
        double integral = std::exp(z / 8 - t) / 2;
        for (int k = 1; t * (k * step) * (k * step) < negligible; ++k) {
            double const square = (k * step) * (k * step);
            integral += std::exp(z / (8 * (square + 1)) - t * (square + 1));
        }
        sum += coefficient * odd * integral * step;
        coefficient *= -(0.5 + j) / (j + 1);
    }
    return std::clamp(std::sqrt(2 * std::numbers::pi) / z * sum, 0.0, 1.0);
}

Test anderson_darling(std::vector<double> probabilities) {
    require_sample(probabilities);
    std::sort(probabilities.begin(), probabilities.end());
    auto const size = static_cast<double>(probabilities.size());
    // A probability of exactly 0 or 1, which rounding can make, has no logarithm.
    constexpr double least = std::numeric_limits<double>::min();
    double sum = 0;
    for (std::size_t i = 0; i < probabilities.size(); ++i) {
        double const low = std::max(probabilities[i], least);
        double const high = std::max(1 - probabilities[probabilities.size() - 1 - i], least);
        sum += (2 * static_cast<double>(i) + 1) * (std::log(low) + std::log(high));
    }
    double const statistic = -size - sum / size;
    double const limit = anderson_darling_limit(statistic);
    return {statistic, std::clamp(1 - limit - anderson_darling_correction(size, limit), 0.0, 1.0)};
}

} // namespace clack::validation
