#pragma once
// Where a result comes from.

#include "validation/harness/options.hpp"

#include <string>
#include <vector>

namespace clack::validation {

/// Lines `name: value` that say which program on which machine made a result.
std::vector<std::string> provenance(std::string const& stem, std::string const& question,
                                    Options const& options);

} // namespace clack::validation
