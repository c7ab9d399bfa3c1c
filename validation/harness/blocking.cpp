#include "validation/harness/blocking.hpp"

#include <cmath>
#include <stdexcept>

namespace clack::validation {

namespace {

/// Means of neighbours, two by two; a last odd one is left out.
std::vector<double> halved(std::vector<double> const& series) {
    std::vector<double> half;
    for (std::size_t i = 0; i + 1 < series.size(); i += 2)
        half.push_back((series[i] + series[i + 1]) / 2);
    return half;
}

} // namespace

Estimate mean_of_series(std::vector<double> series) {
    if (series.size() < 4)
        throw std::invalid_argument("a correlated series takes at least four members");
    auto const count = static_cast<double>(series.size());
    Estimate const single = mean_of(series);
    Estimate best = single;
    double block = 1;
    while (best.error > 0 &&
           std::pow(block, 3) <= 2 * count * std::pow(best.error / single.error, 4) &&
           series.size() >= 4) {
        series = halved(series);
        block *= 2;
        Estimate const level = mean_of(series);
        best.error = level.error;
        best.degrees_of_freedom = level.degrees_of_freedom;
    }
    return best;
}

double statistical_inefficiency(std::vector<double> const& series) {
    double const ratio = mean_of_series(series).error / mean_of(series).error;
    return ratio * ratio;
}

} // namespace clack::validation
