#pragma once
// Do the members of a series remember one another?

#include <vector>

namespace clack::validation {

/// How many members of a series weigh as much as one independent one: (error of the mean by
/// blocking / error if they were independent)^2, 1 for an independent series. Throws
/// std::invalid_argument for a series too short to tell, or of equal members.
double statistical_inefficiency(std::vector<double> const& series);

} // namespace clack::validation
