#pragma once
// A thin layer over HDF5's C interface: handles that close themselves, failures that are
// exceptions, and the few calls that a trajectory needs.

#include <hdf5.h>

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace clack::hdf5 {

/// A call that HDF5 refused: what was tried and the innermost reason, on one line, without the
/// file's name (whoever opened the file knows it).
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Owns one HDF5 identifier.
class Id {
public:
    using Close = herr_t (*)(hid_t);

    Id() = default;
    Id(hid_t id, Close close) : id_(id), close_(close) {}
    Id(Id&& other) noexcept
        : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
    Id& operator=(Id&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(close_, other.close_);
        return *this;
    }
    Id(Id const&) = delete;
    Id& operator=(Id const&) = delete;
    ~Id() { reset(); }

    hid_t get() const { return id_; }
    explicit operator bool() const { return id_ >= 0; }
    void reset();
    hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }

private:
    hid_t id_ = H5I_INVALID_HID;
    Close close_ = nullptr;
};

/// After a failed write: no handle is closed any more, so that HDF5 writes nothing further and the
/// file stays as its last whole flush left it. For the rest of the process.
void leave_files_as_they_are();

/// Throws Error("cannot `task`: reason") when an HDF5 call returned a negative value.
hid_t checked(hid_t result, std::string const& task);
herr_t checked_status(herr_t result, std::string const& task);

/// How a file is opened for reading.
enum class Sharing { exclusive, with_writer };

/// A new file in the one format that single-writer-multiple-readers works with.
Id create_file(std::string const& path);
Id open_file(std::string const& path, Sharing sharing);
/// From here on other processes may read the file while this one appends; no new objects.
void share_with_readers(Id const& file);
void flush_file(Id const& file);

Id create_group(Id const& parent, std::string const& name);
Id open_group(Id const& parent, std::string const& name);
Id open_dataset(Id const& parent, std::string const& name);
bool exists(Id const& parent, std::string const& path);
std::vector<std::string> children(Id const& group);
void hard_link(Id const& from, std::string const& name, Id const& to, std::string const& new_name);

std::vector<hsize_t> shape(Id const& dataset);

/// HDF5's name for a C++ number.
template <class Number> hid_t native_type();
template <> inline hid_t native_type<double>() { return H5T_NATIVE_DOUBLE; }
template <> inline hid_t native_type<std::int8_t>() { return H5T_NATIVE_INT8; }
template <> inline hid_t native_type<std::int32_t>() { return H5T_NATIVE_INT32; }
template <> inline hid_t native_type<std::int64_t>() { return H5T_NATIVE_INT64; }
template <> inline hid_t native_type<std::uint64_t>() { return H5T_NATIVE_UINT64; }

} // namespace clack::hdf5
