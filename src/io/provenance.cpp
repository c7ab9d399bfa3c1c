#include "io/provenance.hpp"

#include <clack_build.hpp> // made by the build: CLACK_VERSION, CLACK_COMMIT, CLACK_FLAGS

#include <sys/utsname.h>

#include <fstream>

namespace clack {

namespace {

std::string compiler() {
#if defined(__clang__)
    return "clang++ " __clang_version__;
#elif defined(__GNUC__)
    return "g++ " __VERSION__;
#else
    return "unknown";
#endif
}

/// The processor's name as Linux tells it; empty elsewhere.
std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        auto const colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return ", " + line.substr(colon + 2);
        }
    }
    return "";
}

std::string machine() {
    utsname names{};
    if (uname(&names) != 0) return "unknown";
    return std::string(names.sysname) + " " + names.release + " " + names.machine + ", " +
           names.nodename + processor();
}

} // namespace

Provenance const& own_provenance() {
    static Provenance const own{CLACK_VERSION, CLACK_COMMIT, compiler(), CLACK_FLAGS, machine()};
    return own;
}

} // namespace clack
