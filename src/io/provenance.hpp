#pragma once
// Which program, built how and run where, made a file.

#include <string>

namespace clack {

struct Provenance {
    std::string version;  // of clack
    std::string commit;   // of its source, "-dirty" when changed since; "unknown" outside git
    std::string compiler; // name and version
    std::string flags;    // that every file was compiled with
    std::string machine;  // system, node and processor of the run
};

/// Of this program on this machine.
Provenance const& own_provenance();

} // namespace clack
