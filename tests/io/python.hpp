#pragma once
// The python that sees Debian's packages; a bare python3 on the PATH may be another.

#include <cstdlib>
#include <string>

namespace clack::test {

/// Empty when there is none.
inline std::string python() {
    static std::string const found = [] {
        for (std::string const name : {"python3", "/usr/bin/python3"}) {
            auto const command = name + " -c 'import h5py, MDAnalysis' >/dev/null 2>&1";
            if (std::system(command.c_str()) == 0) return name;
        }
        return std::string();
    }();
    return found;
}

} // namespace clack::test
