#include "validation/harness/many_tests.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace clack::validation {

std::vector<double> holm(std::vector<double> const& p_values) {
    std::vector<std::size_t> by_size(p_values.size());
    std::iota(by_size.begin(), by_size.end(), 0);
    std::sort(by_size.begin(), by_size.end(),
              [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });

    std::vector<double> adjusted(p_values.size());
    double largest = 0;
    for (std::size_t rank = 0; rank < by_size.size(); ++rank) {
        auto const open = static_cast<double>(by_size.size() - rank); // not yet refused
        largest = std::max(largest, std::min(1.0, open * p_values[by_size[rank]]));
        adjusted[by_size[rank]] = largest;
    }
    return adjusted;
}

double fisher(std::vector<double> const& p_values) {
    double sum = 0;
    for (double const p : p_values)
        sum -= 2 * std::log(std::max(p, std::numeric_limits<double>::min()));
    return gsl_cdf_chisq_Q(sum, 2 * static_cast<double>(p_values.size()));
}

} // namespace clack::validation
