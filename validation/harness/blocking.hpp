#pragma once
// The error of a mean over a series whose members remember one another.

#include "validation/harness/interval.hpp"

#include <vector>

namespace clack::validation {

/// Mean of a correlated series: neighbours are averaged in pairs, again and again, until the blocks
/// are long enough to be independent. Of the levels the first is taken at which the block length B
/// obeys B^3 > 2 n (s_B / s_0)^4, s_B being the standard error from blocks of B.
/// Sources: H. Flyvbjerg, H. G. Petersen, J. Chem. Phys. 91, 461 (1989); the choice of level:
/// R. M. Lee, G. J. Conduit, N. Nemec, P. Lopez Rios, N. D. Drummond, Phys. Rev. E 83, 066706
/// (2011).
/// Throws std::invalid_argument for fewer than four members.
Estimate mean_of_series(std::vector<double> series);

/// How many members of the series weigh as much as one independent one: (error of the mean / error
/// if they were independent)^2, 1 for an independent series.
double statistical_inefficiency(std::vector<double> const& series);

} // namespace clack::validation
