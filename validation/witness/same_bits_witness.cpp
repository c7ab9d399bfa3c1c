// The methods' hashes as another compiler, or other instructions, give them. Built by each of the
// variants in CMakeLists.txt and asked by the experiment same_bits.

#include "validation/same_bits.hpp"

#include <cstdio>

int main() {
    for (auto const& [scene, search, queue, hash] : clack::validation::go_all_ways_by_methods())
        std::printf("%s,%s,%s,%016llx\n", scene.c_str(), search.c_str(), queue.c_str(),
                    static_cast<unsigned long long>(hash));
}
