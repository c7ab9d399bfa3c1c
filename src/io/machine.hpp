#pragma once
// What a program was compiled by and runs on.

#include <string>

namespace clack {

/// The compiler's name and version.
std::string compiler();

/// The processor's name as Linux tells it; "unknown" elsewhere.
std::string processor();

} // namespace clack
