#include "scenes/message.hpp"
#include "scenes/scene.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

namespace clack {

namespace {

constexpr std::size_t largest_scene_file = std::size_t{64} << 20; // larger ones are data

} // namespace

Scene read_scene(std::string const& path, std::vector<std::string> const& overrides) {
    std::error_code unknown; // a file that cannot be asked is one that cannot be opened
    if (std::filesystem::is_directory(path, unknown))
        throw input_error(fmt::format("{}: is a directory; name a scene file (.toml)", path));
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw input_error(fmt::format("{}: {}; name a scene file (.toml)", path,
                                      std::filesystem::exists(path, unknown) ? "cannot be read"
                                                                             : "no such file"));
    }
    std::string text;
    // One block at a time with an end in sight: the path may name a pipe or an endless device.
    for (char block[1 << 16]; file.read(block, sizeof block) || file.gcount() > 0;) {
        text.append(block, static_cast<std::size_t>(file.gcount()));
        if (text.size() > largest_scene_file) {
            throw input_error(
                fmt::format("{}: is larger than {} MiB; keep many balls in a file and "
                            "use arrangement = \"file\"",
                            path, largest_scene_file >> 20));
        }
    }
    if (file.bad())
        throw input_error(fmt::format("{}: cannot be read to its end; copy it anew", path));
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
        throw input_error(fmt::format("{}: is empty; a scene needs [container], [balls], "
                                      "[velocities] and [run]",
                                      path));
    }
    return parse_scene(text, path, overrides);
}

} // namespace clack
