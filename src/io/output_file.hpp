#pragma once
// A file that comes into being under a temporary name and is moved into place when it is whole.

#include <string>

namespace clack {

/// What may stand in an output's place already.
enum class Replacing { trajectories, any_file };

/// Throws InputError unless a file of this name can be made: the folder must exist and take new
/// files, and what stands there already must be an ordinary file that no process of ours is
/// writing; where only trajectories may be replaced, an HDF5 file or an empty one.
void require_writable(std::string const& path, Replacing replacing = Replacing::trajectories);

/// The file that a name stands for: where a symbolic link leads, so that the link stays.
std::string real_path(std::string const& path);

/// The lock that tells others that a process is writing a file; it ends with the process. Readers
/// need not care. Where a file system knows no such locks there is none.
class WriterLock {
public:
    WriterLock() = default;
    /// Throws FileError(in_use) when another process holds it.
    explicit WriterLock(std::string const& path);
    WriterLock(WriterLock&& other) noexcept;
    WriterLock& operator=(WriterLock&& other) noexcept;
    ~WriterLock();

private:
    int descriptor_ = -1;
};

/// The temporary name for `path`, in the same folder; what a failed start left there is removed,
/// and so is this one's, unless it is moved into place.
class TemporaryName {
public:
    explicit TemporaryName(std::string path);
    TemporaryName(TemporaryName const&) = delete;
    TemporaryName& operator=(TemporaryName const&) = delete;
    ~TemporaryName();

    std::string const& name() const { return name_; }
    bool in_place() const { return in_place_; }
    /// Throws WriteError when it cannot.
    void move_into_place();

private:
    std::string path_, name_;
    bool in_place_ = false;
};

} // namespace clack
