#pragma once
// Reads trajectories: clack's own, also while they are written or after their writer was killed,
// and the last frame of anybody's H5MD file.

#include "io/checkpoint_slots.hpp"
#include "io/layout.hpp"
#include "io/trajectory_header.hpp"

#include <optional>
#include <string>

namespace clack {

/// One of clack's files. It shows what the file held when it was opened. Every member throws
/// FileError, one line that names the file and what is wrong with it.
class TrajectoryReader {
public:
    explicit TrajectoryReader(std::string const& path);

    std::string const& path() const { return path_; }
    TrajectoryHeader const& header() const { return header_; }

    /// Frames that are there in full.
    std::size_t frame_count() const { return frames_.rows(); }
    double frame_time(std::size_t frame) const;
    Snapshot snapshot(std::size_t frame) const;
    Sample frame_sample(std::size_t frame) const;

    std::size_t sample_count() const { return samples_.rows(); }
    std::vector<Sample> samples(std::size_t count) const;

    std::size_t event_count() const { return events_ ? events_->rows() : 0; }
    std::vector<Collision<double>> events(std::size_t first, std::size_t count) const;

    /// Where the run can go on. Throws FileError: no_checkpoint when no slot is whole, truncated
    /// when the file is shorter than it was then, or holds less.
    ResumePoint const& resume_point() const;

    /// Whether the file's writer is at work, or was killed, rather than having closed it.
    bool left_open() const { return sharing_ == hdf5::Sharing::with_writer; }

    FrameSeries const& frame_series() const { return frames_; }
    EventSeries const& event_series() const { return *events_; }

private:
    template <class Task> auto guarded(Task const& task) const;

    std::string path_;
    hdf5::Sharing sharing_ = hdf5::Sharing::exclusive;
    hdf5::Id file_;
    TrajectoryHeader header_;
    std::optional<ResumePoint> point_;
    FrameSeries frames_;
    SampleSeries samples_;
    std::optional<EventSeries> events_;
};

/// Whether a file is there and calls itself HDF5.
bool is_hdf5(std::string const& path);

/// The last frame of any H5MD file: of its particle group `balls`, else of its only one with
/// positions. Without stored velocities those are left empty. Throws FileError.
Start last_frame(std::string const& path);

} // namespace clack
