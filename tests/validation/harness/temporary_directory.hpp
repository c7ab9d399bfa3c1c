#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

/// A directory that goes when the test does.
struct TemporaryDirectory {
    std::filesystem::path path;

    explicit TemporaryDirectory(std::string const& name)
        : path(std::filesystem::temp_directory_path() /
               ("clack_" + name + "_" + std::to_string(getpid()))) {
        std::filesystem::create_directories(path);
    }
    ~TemporaryDirectory() { std::filesystem::remove_all(path); }
    TemporaryDirectory(TemporaryDirectory const&) = delete;
    TemporaryDirectory& operator=(TemporaryDirectory const&) = delete;
};

inline std::string text_of(std::filesystem::path const& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}
