#pragma once
// Many tests at once: what a p-value is still worth.

#include <vector>

namespace clack::validation {

/// Holm's adjusted p-values, in the order of the given ones: refusing every hypothesis whose
/// adjusted p-value is below alpha refuses a true one with probability at most alpha, whatever the
/// dependence between the tests.
/// Source: S. Holm, Scand. J. Statist. 6, 65 (1979).
std::vector<double> holm(std::vector<double> const& p_values);

/// Fisher's p-value of independent tests of one hypothesis taken together.
/// Source: R. A. Fisher, Statistical Methods for Research Workers (4th ed., 1932), section 21.1.
double fisher(std::vector<double> const& p_values);

} // namespace clack::validation
