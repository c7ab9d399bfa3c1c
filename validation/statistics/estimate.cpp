#include "validation/statistics/estimate.hpp"

#include "observables/blocking.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace clack::validation {

Estimate mean_of(std::vector<double> const& replicates) {
    if (replicates.size() < 2)
        throw std::invalid_argument("an error takes at least two replicates");
    auto const count = static_cast<double>(replicates.size());
    double const mean = std::accumulate(replicates.begin(), replicates.end(), 0.0) / count;
    double squares = 0;
    for (double const value : replicates) squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / (count * (count - 1))), count - 1};
}

Estimate mean_of(std::vector<Measurement> const& replicates, std::size_t const place) {
    return mean_of(replicates, [=](Measurement const& values) {
        if (place >= values.size())
            throw std::invalid_argument(
                fmt::format("place = {}: a replicate measured {} numbers", place, values.size()));
        return values[place];
    });
}

Estimate median_of(std::vector<double> values) {
    Estimate const mean = mean_of(values);
    double const median = gsl_stats_median(values.data(), 1, values.size());
    return {median, std::sqrt(std::numbers::pi / 2) * mean.error, mean.degrees_of_freedom};
}

double half_width(Estimate const& estimate, double const confidence) {
    double const tail = (1 - confidence) / 2;
    return estimate.error * (std::isinf(estimate.degrees_of_freedom)
                                 ? gsl_cdf_ugaussian_Qinv(tail)
                                 : gsl_cdf_tdist_Qinv(tail, estimate.degrees_of_freedom));
}

double upper_tail(double const t, double const degrees_of_freedom) {
    return std::isinf(degrees_of_freedom) ? gsl_cdf_ugaussian_Q(t)
                                          : gsl_cdf_tdist_Q(t, degrees_of_freedom);
}

double statistical_inefficiency(std::vector<double> const& series) {
    std::vector<double> times(series.size() + 1), sums{0};
    std::iota(times.begin(), times.end(), 0.0);
    for (double const value : series) sums.push_back(sums.back() + value);
    auto const blocked = rate_by_blocking(times, sums).error;
    double const independent = series.size() < 2 ? 0 : mean_of(series).error;
    if (!blocked || !(independent > 0))
        throw std::invalid_argument("the series is too short, or constant");
    return *blocked * *blocked / (independent * independent);
}

StraightLine line_through(std::vector<double> const& x, std::vector<double> const& y) {
    StraightLine line;
    double c00 = 0, c01 = 0, c11 = 0, squares = 0;
    gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &line.at_0, &line.slope, &c00, &c01, &c11,
                   &squares);
    return line;
}

MeasuredLine line_through(std::vector<double> const& x, std::vector<Estimate> const& y) {
    std::vector<double> values, weights;
    for (Estimate const& point : y) {
        values.push_back(point.value);
        weights.push_back(1 / (point.error * point.error));
    }
    MeasuredLine line;
    double c00 = 0, c01 = 0, c11 = 0, squares = 0;
    gsl_fit_wlinear(x.data(), 1, weights.data(), 1, values.data(), 1, x.size(), &line.at_0.value,
                    &line.slope.value, &c00, &c01, &c11, &squares);
    line.at_0.error = std::sqrt(c00);
    line.slope.error = std::sqrt(c11);
    return line;
}

double worse(double const a, double const b) { return std::isnan(a) || a >= b ? a : b; }

} // namespace clack::validation
