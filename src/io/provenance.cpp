#include "io/provenance.hpp"

#include "io/machine.hpp"
#include <clack_build.hpp> // made by the build: CLACK_VERSION, CLACK_COMMIT, CLACK_FLAGS

#include <sys/utsname.h>

namespace clack {

namespace {

std::string machine() {
    utsname names{};
    if (uname(&names) != 0) return "unknown";
    return std::string(names.sysname) + " " + names.release + " " + names.machine + ", " +
           names.nodename + ", " + processor();
}

} // namespace

Provenance const& own_provenance() {
    static Provenance const own{CLACK_VERSION, CLACK_COMMIT, compiler(), CLACK_FLAGS, machine()};
    return own;
}

} // namespace clack
