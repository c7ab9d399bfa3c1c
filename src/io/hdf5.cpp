#include "io/hdf5.hpp"

#include <algorithm>
#include <atomic>

namespace clack::hdf5 {

namespace {

std::atomic<bool> files_are_left_alone = false;

/// HDF5 would print its own stack of errors, one for each thread, and, at exit, try again to close
/// what a full disk kept open; both are ours to do.
void take_charge() {
    static bool const once = [] {
        H5dont_atexit();
        H5open();
        return true;
    }();
    static_cast<void>(once);
    thread_local bool const quiet = [] {
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
        return true;
    }();
    static_cast<void>(quiet);
}

/// The innermost entry of HDF5's stack of errors: where the trouble was met first.
herr_t keep_first(unsigned, H5E_error2_t const* error, void* text) {
    auto& kept = *static_cast<std::string*>(text);
    if (kept.empty() && error->desc) kept = error->desc;
    return 0;
}

std::string innermost_reason() {
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
    H5Eclear2(H5E_DEFAULT);
    // The drivers wrap the system's own words: "..., error message = 'No space left on device',
    // ..."
    std::string const mark = "error message = '";
    if (auto const at = reason.find(mark); at != std::string::npos) {
        auto const begin = at + mark.size();
        return reason.substr(begin, reason.find('\'', begin) - begin);
    }
    return reason.empty() ? "HDF5 gives no reason" : reason;
}

Id access_list() {
    Id list(checked(H5Pcreate(H5P_FILE_ACCESS), "prepare a file"), H5Pclose);
    // 1.10's format is the oldest that can be read while it is written.
    checked_status(H5Pset_libver_bounds(list.get(), H5F_LIBVER_V110, H5F_LIBVER_V110),
                   "prepare a file");
    return list;
}

} // namespace

void Id::reset() {
    if (id_ >= 0 && close_ && !files_are_left_alone) {
        close_(id_);
        H5Eclear2(H5E_DEFAULT);
    }
    id_ = H5I_INVALID_HID;
}

void leave_files_as_they_are() { files_are_left_alone = true; }

hid_t checked(hid_t result, std::string const& task) {
    if (result < 0) throw Error("cannot " + task + ": " + innermost_reason());
    return result;
}

herr_t checked_status(herr_t result, std::string const& task) {
    if (result < 0) throw Error("cannot " + task + ": " + innermost_reason());
    return result;
}

Id create_file(std::string const& path) {
    take_charge();
    return {checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access_list().get()),
                    "create the file"),
            H5Fclose};
}

Id open_file(std::string const& path, Sharing sharing) {
    take_charge();
    unsigned const flags =
        sharing == Sharing::exclusive ? H5F_ACC_RDONLY : H5F_ACC_RDONLY | H5F_ACC_SWMR_READ;
    return {checked(H5Fopen(path.c_str(), flags, H5P_DEFAULT), "open the file"), H5Fclose};
}

void share_with_readers(Id const& file) {
    checked_status(H5Fstart_swmr_write(file.get()), "share the file with readers");
}

void flush_file(Id const& file) {
    checked_status(H5Fflush(file.get(), H5F_SCOPE_GLOBAL), "flush the file");
}

Id create_group(Id const& parent, std::string const& name) {
    return {checked(H5Gcreate2(parent.get(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                    "create group " + name),
            H5Gclose};
}

Id open_group(Id const& parent, std::string const& name) {
    return {checked(H5Gopen2(parent.get(), name.c_str(), H5P_DEFAULT), "open group " + name),
            H5Gclose};
}

Id open_dataset(Id const& parent, std::string const& name) {
    return {checked(H5Dopen2(parent.get(), name.c_str(), H5P_DEFAULT), "open dataset " + name),
            H5Dclose};
}

bool exists(Id const& parent, std::string const& path) {
    // HDF5 answers for one link at a time only.
    for (std::size_t end = 0; end != std::string::npos;) {
        end = path.find('/', end + 1);
        bool const found = H5Lexists(parent.get(), path.substr(0, end).c_str(), H5P_DEFAULT) > 0;
        if (!found) {
            H5Eclear2(H5E_DEFAULT);
            return false;
        }
    }
    return true;
}

std::vector<std::string> children(Id const& group) {
    auto const keep_name = [](hid_t, char const* name, H5L_info_t const*, void* names) -> herr_t {
        static_cast<std::vector<std::string>*>(names)->emplace_back(name);
        return 0;
    };
    std::vector<std::string> names;
    hsize_t position = 0;
    checked_status(
        H5Literate(group.get(), H5_INDEX_NAME, H5_ITER_INC, &position, keep_name, &names),
        "list a group");
    return names;
}

void hard_link(Id const& from, std::string const& name, Id const& to, std::string const& new_name) {
    checked_status(H5Lcreate_hard(from.get(), name.c_str(), to.get(), new_name.c_str(), H5P_DEFAULT,
                                  H5P_DEFAULT),
                   "link " + new_name);
}

std::vector<hsize_t> shape(Id const& dataset) {
    Id const space(checked(H5Dget_space(dataset.get()), "read a dataset's shape"), H5Sclose);
    std::vector<hsize_t> sizes(
        static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space.get()), 0)));
    H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr);
    return sizes;
}

} // namespace clack::hdf5
