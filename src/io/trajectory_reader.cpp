#include "io/trajectory_reader.hpp"

#include "io/file_errors.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace clack {

namespace {

namespace fs = std::filesystem;

/// What HDF5 trips over in a file that was opened well is a loss of part of it.
[[noreturn]] void throw_truncated(std::string const& path, std::string const& what) {
    throw FileError(FileFault::truncated,
                    path + ": is truncated or damaged (" + what + "); use a whole copy");
}

void require_hdf5(std::string const& path) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file || fs::is_directory(path)) {
        throw FileError(FileFault::missing, path + ": cannot be read (" +
                                                (errno ? std::strerror(errno) : "not a file") +
                                                "); check the name");
    }
    if (!is_hdf5(path)) {
        throw FileError(FileFault::not_hdf5, path + ": is not an HDF5 file; give a trajectory");
    }
}

/// A file whose writer is at work, or was killed, says so and opens only for sharing with it.
struct OpenFile {
    hdf5::Sharing sharing;
    hdf5::Id id;
};

OpenFile open_shared_if_needed(std::string const& path) {
    require_hdf5(path);
    try {
        return {hdf5::Sharing::exclusive, hdf5::open_file(path, hdf5::Sharing::exclusive)};
    } catch (hdf5::Error const&) { // it may be shared; if it is truncated, that fails alike
    }
    try {
        return {hdf5::Sharing::with_writer, hdf5::open_file(path, hdf5::Sharing::with_writer)};
    } catch (hdf5::Error const& error) {
        throw_truncated(path, error.what());
    }
}

/// HDF5 itself sees whether a closed file has its end, and closing may have made it shorter; of one
/// left open it would read what is lost as zeros.
void require_end(hdf5::Sharing sharing, std::optional<ResumePoint> const& point,
                 std::string const& path) {
    bool const left_open = sharing == hdf5::Sharing::with_writer;
    if (left_open && point && fs::file_size(path) < point->file_bytes) {
        throw_truncated(path, "it is shorter than its checkpoint says");
    }
}

/// The group of particles that a start is read from.
hdf5::Id particle_group(hdf5::Id const& file, std::string const& path) {
    auto const particles = hdf5::open_group(file, "particles");
    auto const has_positions = [&](std::string const& name) {
        return hdf5::exists(particles, name + "/position/value");
    };
    std::vector<std::string> candidates;
    for (auto const& name : hdf5::children(particles)) {
        if (has_positions(name)) candidates.push_back(name);
    }
    if (has_positions("balls")) return hdf5::open_group(particles, "balls");
    if (candidates.size() != 1) {
        throw FileError(FileFault::not_h5md,
                        path + ": has " + std::to_string(candidates.size()) +
                            " particle groups with positions over time; one, or one named balls, "
                            "is needed");
    }
    return hdf5::open_group(particles, candidates.front());
}

/// The last row of a series of [count][3] numbers.
Eigen::Matrix3Xd last_row(hdf5::Id const& group, std::string const& name, std::string const& path) {
    auto const series = hdf5::Series<double>::open(group, name);
    auto const& shape = series.row_shape();
    if (shape.size() != 2 || shape[1] != 3 || series.rows() == 0) {
        throw FileError(FileFault::not_h5md,
                        path + ": " + name + " holds no frame of places in three dimensions");
    }
    Eigen::Matrix3Xd row(3, static_cast<Eigen::Index>(shape[0]));
    series.read_into(series.rows() - 1, 1, row.data());
    return row;
}

} // namespace

template <class Task> auto TrajectoryReader::guarded(Task const& task) const {
    try {
        return task();
    } catch (hdf5::Error const& error) {
        throw_truncated(path_, error.what());
    } catch (std::out_of_range const&) {
        throw_truncated(path_, "a dataset has another shape than clack writes");
    }
}

TrajectoryReader::TrajectoryReader(std::string const& path) : path_(path) {
    guarded([&] {
        auto opened = open_shared_if_needed(path);
        sharing_ = opened.sharing;
        file_ = std::move(opened.id);
        header_ = read_header(file_, path);
        // First, so that a writer at work cannot make it newer than what is then found beside it.
        point_ = CheckpointSlots::open(file_).read();
        require_end(sharing_, point_, path);
        frames_ = FrameSeries::open(file_);
        samples_ = SampleSeries::open(file_);
        if (header_.events == Events::stored) events_ = EventSeries::open(file_);
    });
}

double TrajectoryReader::frame_time(std::size_t frame) const {
    return guarded([&] { return frames_.time(frame); });
}

Snapshot TrajectoryReader::snapshot(std::size_t frame) const {
    return guarded([&] { return frames_.snapshot(frame); });
}

Sample TrajectoryReader::frame_sample(std::size_t frame) const {
    return guarded([&] { return frames_.sample(frame); });
}

std::vector<Sample> TrajectoryReader::samples(std::size_t count) const {
    return guarded([&] { return samples_.read(count); });
}

std::vector<Collision<double>> TrajectoryReader::events(std::size_t first,
                                                        std::size_t count) const {
    return guarded([&] { return events_->read(first, count); });
}

ResumePoint const& TrajectoryReader::resume_point() const {
    if (!point_) {
        throw FileError(FileFault::no_checkpoint,
                        path_ + ": neither of its two checkpoints is whole (checksum); run the "
                                "scene again");
    }
    if (frame_count() < point_->frames || sample_count() < point_->samples ||
        event_count() < point_->events) {
        throw_truncated(path_, "it holds less than its checkpoint says");
    }
    return *point_;
}

bool is_hdf5(std::string const& path) {
    std::ifstream file(path, std::ios::binary);
    char start[8] = {};
    file.read(start, sizeof start);
    return std::memcmp(start, "\x89HDF\r\n\x1a\n", sizeof start) == 0;
}

Start last_frame(std::string const& path) {
    auto const [sharing, file] = open_shared_if_needed(path);
    try {
        require_h5md(file, path);
        if (hdf5::exists(file, "checkpoint/b/header")) { // clack's own
            require_end(sharing, CheckpointSlots::open(file).read(), path);
        }
        auto const group = particle_group(file, path);
        Start start;
        start.positions = last_row(group, "position/value", path);
        if (hdf5::exists(group, "velocity/value")) {
            start.velocities = last_row(group, "velocity/value", path);
        }
        return start;
    } catch (hdf5::Error const& error) {
        throw_truncated(path, error.what());
    }
}

} // namespace clack
