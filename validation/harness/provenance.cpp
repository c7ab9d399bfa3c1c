#include "validation/harness/provenance.hpp"

#include "validation/harness/campaign.hpp"
#include <clack_build.hpp> // made by the build: CLACK_VERSION, CLACK_FLAGS

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

namespace clack::validation {

namespace {

/// The commit of the source tree, asked for when the program runs: compiled in, it would make every
/// commit a new program, whose campaigns start over.
std::string commit() {
    auto const root = std::filesystem::path(CLACK_REFERENCE_DIR).parent_path();
    std::string const command =
        fmt::format("git -C '{}' describe --always --dirty --abbrev=12 2>/dev/null", root.string());
    std::unique_ptr<FILE, int (*)(FILE*)> const pipe(popen(command.c_str(), "r"), pclose);
    char answer[128] = "";
    if (!pipe || !std::fgets(answer, sizeof answer, pipe.get())) return "unknown";
    std::string const line = answer;
    return line.substr(0, line.find('\n'));
}

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

std::string compiler() {
#if defined(__clang__)
    return "clang++ " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

} // namespace

std::vector<std::string> provenance(std::string const& stem, std::string const& question,
                                    Options const& options) {
    return {"experiment: " + stem,
            "question: " + question,
            fmt::format("profile: {}", name_of(options.profile)),
            fmt::format("version: {}", CLACK_VERSION),
            "commit: " + commit(),
            "program: " + program_hash(),
            "compiler: " + compiler(),
            fmt::format("flags: {}", CLACK_FLAGS),
            "machine: " + processor(),
            "seeds: hashed from experiment, state point and replicate; each stands in " + stem +
                ".replicates"};
}

} // namespace clack::validation
