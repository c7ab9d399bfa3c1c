// Do all searches, queues, instructions and compilers move the balls to the same last bit?

#include "validation/same_bits.hpp"
#include "validation/child_process.hpp"
#include "validation/harness/experiment.hpp"

#include <fmt/format.h>

#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

namespace clack::validation {

Question const question{
    "same_bits",
    "Do all searches, queues, vector instructions, optimisation levels and compilers move the "
    "balls to the same last bit?",
    "none",
    "one hash a scene over the collision sequence, the bits of its times and of the outgoing "
    "velocities; two different sequences share a hash once in 2^64"};

namespace {

/// The hashes that one build gives.
struct Build {
    std::string name;
    std::vector<WayHash> hashes;
};

Build this_build() {
    Build build{"as installed", go_all_ways_by_methods()};
    for (Way const& way : ways) {
        if (way.boundary == Boundary::walls)
            go_by_the_rest<WalledCube>(way, build.hashes);
        else
            go_by_the_rest<PeriodicCube>(way, build.hashes);
    }
    return build;
}

/// Runs a witness program and reads what it prints.
Build witness(std::string const& name, std::string const& program) {
    Build build{name, {}};
    std::istringstream output(output_of(program));
    for (std::string line; std::getline(output, line);) {
        std::istringstream fields(line);
        WayHash way;
        std::string hash;
        std::getline(fields, way.scene, ',');
        std::getline(fields, way.search, ',');
        std::getline(fields, way.queue, ',');
        std::getline(fields, hash);
        way.hash = std::stoull(hash, nullptr, 16);
        build.hashes.push_back(way);
    }
    if (build.hashes.empty())
        throw std::runtime_error(name + ": the witness did not run: " + program);
    return build;
}

/// This build, and the witnesses that CMake could build: "name=program|name=program".
std::vector<Build> builds() {
    std::vector<Build> all{this_build()};
    std::istringstream list(CLACK_WITNESSES);
    for (std::string entry; std::getline(list, entry, '|');) {
        auto const split = entry.rfind('=');
        all.push_back(witness(entry.substr(0, split), entry.substr(split + 1)));
    }
    return all;
}

} // namespace

Verdict ask(Experiment& experiment) {
    auto const all = builds();
    std::map<std::string, std::set<std::uint64_t>> hashes;
    std::size_t runs = 0;
    Csv csv({"build", "scene", "search", "queue", "hash"});
    for (Build const& build : all) {
        for (WayHash const& way : build.hashes) {
            hashes[way.scene].insert(way.hash);
            csv.row(build.name, way.scene, way.search, way.queue, fmt::format("{:016x}", way.hash));
            ++runs;
        }
    }
    std::vector<std::vector<std::string>> rows;
    Verdict verdict = Verdict::agrees;
    for (auto const& way : ways) {
        auto const& found = hashes[way.name()];
        if (found.size() != 1) verdict = Verdict::differs;
        std::string const shown = found.size() == 1 ? fmt::format("{:016x}", *found.begin())
                                                    : fmt::format("{} different", found.size());
        std::cout << fmt::format("{:20} {:6} collisions: {}\n", way.name(), way.collisions, shown);
        rows.push_back({way.boundary == Boundary::walls ? "walls" : "periodic", cell(way.count),
                        fmt::format("{:g}", way.packing_fraction), cell(way.collisions),
                        "\\texttt{" + shown + "}"});
    }
    experiment.write(csv);
    experiment.write_table(
        tabular("lrrrl", {"boundary", "$n$", "$\\eta$", "collisions", "hash"}, rows));
    Macros macros("SameBits");
    macros.define("Builds", cell(all.size()));
    macros.define("Runs", cell(runs));
    std::string names;
    for (Build const& build : all) names += (names.empty() ? "" : "; ") + build.name;
    macros.define("BuildNames", names);
    experiment.write(macros);
    return verdict;
}

} // namespace clack::validation
