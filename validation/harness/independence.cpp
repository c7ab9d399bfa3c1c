#include "validation/harness/independence.hpp"

#include "observables/blocking.hpp"
#include "validation/harness/interval.hpp"

#include <stdexcept>

namespace clack::validation {

double statistical_inefficiency(std::vector<double> const& series) {
    std::vector<double> times{0}, sums{0};
    for (double const value : series) {
        times.push_back(times.back() + 1);
        sums.push_back(sums.back() + value);
    }
    auto const blocked = rate_by_blocking(times, sums).error;
    double const independent = series.size() < 2 ? 0 : mean_of(series).error;
    if (!blocked || !(independent > 0))
        throw std::invalid_argument("the series is too short, or constant");
    return *blocked * *blocked / (independent * independent);
}

} // namespace clack::validation
