#include "io/output_file.hpp"

#include "io/file_errors.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

namespace clack {

namespace fs = std::filesystem;

namespace {

/// Far beyond any data: locking this byte keeps nobody from reading the file, which a lock on all
/// of it, the kind HDF5 takes, would.
constexpr off_t lock_byte = off_t{1} << 62;

fs::path folder_of(std::string const& path) {
    auto const parent = fs::path(path).parent_path();
    return parent.empty() ? fs::path(".") : parent;
}

std::string temporary_name(std::string const& path) {
    std::string name = ".";
    name += fs::path(path).filename().string();
    name += ".partial";
    return (folder_of(path) / name).string();
}

bool is_empty_or_hdf5(std::string const& path) {
    std::ifstream file(path, std::ios::binary);
    char start[8] = {};
    file.read(start, sizeof start);
    constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
    return file.gcount() == 0 || std::string_view(start, sizeof start) == signature;
}

} // namespace

void require_writable(std::string const& path, Replacing replacing) {
    auto const refuse = [&](std::string const& why) {
        throw InputError("output = " + path + ": " + why);
    };
    auto const folder = folder_of(path);
    std::error_code ignored;
    if (fs::path(path).filename().empty() || fs::is_directory(path, ignored)) {
        refuse("is a folder; name a file in it");
    }
    if (!fs::is_directory(folder, ignored)) {
        refuse("there is no folder " + folder.string() + "; make it first");
    }
    // Trying is the only honest question: rights, quotas and read-only mounts all answer.
    std::string const probe = temporary_name(path);
    int const descriptor = open(probe.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        refuse(std::string("cannot be written (") + std::strerror(errno) +
               "); choose another folder");
    }
    close(descriptor);
    { WriterLock const nobody_is_just_starting(probe); }
    unlink(probe.c_str());
    if (!fs::exists(path, ignored)) return;
    if (!fs::is_regular_file(path, ignored)) refuse("is not an ordinary file; choose another name");
    if (replacing == Replacing::trajectories && !is_empty_or_hdf5(path)) {
        refuse("exists and is not a trajectory; remove it or choose another name");
    }
    WriterLock const nobody_is_writing(path);
}

std::string real_path(std::string const& path) {
    constexpr int links_max = 40; // as the system has it; beyond, links lead in a circle
    std::error_code ignored;
    fs::path real = path;
    for (int link = 0; link < links_max && fs::is_symlink(real, ignored); ++link) {
        real = real.parent_path() / fs::read_symlink(real, ignored); // an absolute one replaces all
    }
    return real.string();
}

WriterLock::WriterLock(std::string const& path) {
    descriptor_ = open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor_ < 0) return; // whether it can be written is found out elsewhere
    struct flock lock = {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start = lock_byte;
    lock.l_len = 1;
    // The lock of an open file, not of the process: HDF5 closing the file elsewhere would drop
    // that.
    if (fcntl(descriptor_, F_OFD_SETLK, &lock) != 0 && (errno == EAGAIN || errno == EACCES)) {
        close(std::exchange(descriptor_, -1));
        throw FileError(FileFault::in_use,
                        path + ": another process is writing it; wait for it or stop it");
    }
}

WriterLock::WriterLock(WriterLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

WriterLock& WriterLock::operator=(WriterLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

WriterLock::~WriterLock() {
    if (descriptor_ >= 0) close(descriptor_);
}

TemporaryName::TemporaryName(std::string path)
    : path_(std::move(path)), name_(temporary_name(path_)) {
    unlink(name_.c_str());
}

TemporaryName::~TemporaryName() {
    if (!in_place_) unlink(name_.c_str());
}

void TemporaryName::move_into_place() {
    if (std::rename(name_.c_str(), path_.c_str()) != 0) {
        throw WriteError(path_ + ": cannot move the file into place: " + std::strerror(errno));
    }
    in_place_ = true;
}

} // namespace clack
