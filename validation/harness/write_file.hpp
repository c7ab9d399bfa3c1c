#pragma once
// Files that are whole or not there.

#include <filesystem>
#include <string>
#include <string_view>

namespace clack::validation {

/// Writes a file under a temporary name and moves it into place, so that whoever sees it sees all
/// of it. Throws InputError when it cannot be written.
void write_file(std::filesystem::path const& path, std::string_view text);

} // namespace clack::validation
