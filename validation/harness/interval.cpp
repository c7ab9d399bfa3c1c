#include "validation/harness/interval.hpp"

#include <gsl/gsl_cdf.h>

#include <cmath>
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

double half_width(Estimate const& estimate, double const confidence) {
    double const tail = (1 - confidence) / 2;
    double const t = std::isinf(estimate.degrees_of_freedom)
                         ? gsl_cdf_ugaussian_Qinv(tail)
                         : gsl_cdf_tdist_Qinv(tail, estimate.degrees_of_freedom);
    return t * estimate.error;
}

double upper_tail(double const t, double const degrees_of_freedom) {
    return std::isinf(degrees_of_freedom) ? gsl_cdf_ugaussian_Q(t)
                                          : gsl_cdf_tdist_Q(t, degrees_of_freedom);
}

} // namespace clack::validation
