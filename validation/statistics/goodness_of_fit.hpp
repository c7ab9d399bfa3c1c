#pragma once
// Is a sample drawn from a law that is known completely, parameters included?

#include <cstdint>
#include <vector>

namespace clack::validation {

/// A test's statistic and the probability of one as large or larger under the law.
struct Test {
    double statistic = 0;
    double p_value = 1;
};

/// Pearson's chi-square of counts in bins that the law gives equal probability.
/// Valid from about 5 expected a bin. Throws std::invalid_argument for fewer than two bins or no
/// counts.
Test chi_square(std::vector<std::int64_t> const& counts);

/// The same in bins of any probabilities, all positive and adding up to 1.
Test chi_square(std::vector<std::int64_t> const& counts, std::vector<double> const& probabilities);

/// Kolmogorov and Smirnov's largest distance between the sample's and the law's distribution.
///   probabilities   the law's distribution function at each of the sample, in any order
/// The p-value is the limit law's with Vrbik's correction for the sample's size, right to 3e-3 at a
/// size of 10 and to 3e-5 at 1000.
/// Source: J. Vrbik, Pioneer J. Theor. Appl. Statist. 15, 15 (2018).
Test kolmogorov_smirnov(std::vector<double> probabilities);

/// Anderson and Darling's A^2, which weighs the tails. Arguments as kolmogorov_smirnov.
/// The p-value is the limit law's with Marsaglia and Marsaglia's correction for the sample's size,
/// right to 1e-4 from a size of 8 on.
/// Source: G. Marsaglia, J. Marsaglia, J. Statist. Software 9(2) (2004),
/// doi:10.18637/jss.v009.i02.
Test anderson_darling(std::vector<double> probabilities);

/// Probability that the limit of sqrt(size) times Kolmogorov and Smirnov's distance is up to x.
double kolmogorov_limit(double x);

/// Probability that the limit of A^2 is up to z, by the series of the source, right to 1e-13 for z
/// up to 100. Source: T. W. Anderson, D. A. Darling, Ann. Math. Statist. 23, 193 (1952),
/// doi:10.1214/aoms/1177729437.
double anderson_darling_limit(double z);

} // namespace clack::validation
