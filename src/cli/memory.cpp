#include "cli/memory.hpp"

#include "state/errors.hpp"

#include <fmt/format.h>

#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace clack {

namespace {

constexpr auto unlimited = std::numeric_limits<std::size_t>::max();

/// The number after `name` in a file of "name number" lines.
std::optional<std::size_t> number_in(char const* path, std::string const& name) {
    std::ifstream file(path);
    std::string word;
    std::size_t number = 0;
    while (file >> word) {
        if (word == name && file >> number) return number;
    }
    return std::nullopt;
}

std::optional<std::size_t> number_in(char const* path) {
    std::ifstream file(path);
    std::size_t number = 0;
    if (file >> number) return number; // "max" is not a number: no limit
    return std::nullopt;
}

std::size_t left(std::size_t limit, std::size_t used) { return limit > used ? limit - used : 0; }

/// What the limit on the process's address space leaves.
std::size_t left_by_limits() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
    constexpr std::size_t page = 4096;
    auto const pages = number_in("/proc/self/statm").value_or(0);
    return left(limit.rlim_cur, pages * page);
}

/// What the control group leaves; its file caches would be given up.
std::size_t left_by_group() {
    auto const limit = number_in("/sys/fs/cgroup/memory.max");
    auto const used = number_in("/sys/fs/cgroup/memory.current");
    if (!limit || !used) return unlimited;
    auto const cached = number_in("/sys/fs/cgroup/memory.stat", "inactive_file").value_or(0);
    return left(*limit, left(*used, cached));
}

} // namespace

std::size_t available_bytes() {
    auto const kilobytes = number_in("/proc/meminfo", "MemAvailable:");
    auto const of_system = kilobytes ? *kilobytes * 1024 : unlimited;
    return std::min({of_system, left_by_limits(), left_by_group()});
}

std::size_t run_bytes(Scene const& scene) {
    std::size_t const limbs = scene.precision == Precision::quadruple  ? 3
                              : scene.precision == Precision::extended ? 2
                                                                       : 1;
    std::size_t const checkpoint = 7 * limbs * sizeof(double) + 3 * sizeof(int);
    auto const count = static_cast<std::size_t>(scene.system.count);
    return expected_bytes(scene.system, scene.method, scene.precision) +
           count * checkpoint; // frames are written from the engine
}

void require_memory(Scene const& scene, std::size_t bytes_beside) {
    auto const needed =
        run_bytes(scene) + static_cast<std::size_t>(scene.system.count) * bytes_beside;
    auto const available = available_bytes();
    if (needed <= available) return;
    throw InputError(fmt::format(
        "count = {}: needs {} of memory, and {} are available; use fewer balls or a larger machine "
        "({})",
        scene.system.count, bytes_in_words(static_cast<double>(needed)),
        bytes_in_words(static_cast<double>(available)), scene.source));
}

void give_back_what_is_freed() {
#ifdef M_MMAP_THRESHOLD
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

std::string bytes_in_words(double bytes) {
    constexpr std::array<char const*, 5> units{"B", "KiB", "MiB", "GiB", "TiB"};
    std::size_t unit = 0;
    for (; bytes >= 1024 && unit + 1 < units.size(); ++unit) bytes /= 1024;
    int const digits = bytes < 10 && unit > 0 ? 1 : 0;
    return fmt::format("{:.{}f} {}", bytes, digits, units[unit]);
}

} // namespace clack
