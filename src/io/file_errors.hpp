#pragma once
// What can be wrong with a file that a user hands over, and with writing one.

#include "state/errors.hpp"

#include <stdexcept>
#include <string>

namespace clack {

enum class FileFault {
    missing,       // not there, or not to be read
    not_hdf5,      // another kind of file
    not_h5md,      // HDF5, but not a trajectory
    not_clack,     // a trajectory of another program, where only clack's own will do
    other_version, // clack's, in a format of another version
    truncated,     // its end is lost, or what it says of itself does not fit together
    no_checkpoint, // neither slot of the checkpoint is whole
    in_use         // another process is writing it
};

/// A file that cannot be used as asked; `what()` is one line: path: what is wrong; what to do.
struct FileError : InputError {
    FileError(FileFault the_fault, std::string const& line) : InputError(line), fault(the_fault) {}
    FileFault fault;
};

/// The file can no longer be written, a full disk for one. What was flushed before stays readable
/// and resumable. Exit code 1.
struct WriteError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace clack
