#include "validation/harness/write_file.hpp"

#include "state/errors.hpp"

#include <fmt/format.h>

#include <fstream>

namespace clack::validation {

void write_file(std::filesystem::path const& path, std::string_view const text) {
    std::filesystem::path temporary = path;
    temporary += ".part";
    {
        std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
        file << text << std::flush;
        if (!file) throw InputError(fmt::format("{}: cannot be written", path.string()));
    }
    std::filesystem::rename(temporary, path);
}

} // namespace clack::validation
