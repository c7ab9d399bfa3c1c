#pragma once
// Writes a run to an H5MD 1.1 file that others can read meanwhile and that survives a kill.

#include "io/checkpoint_slots.hpp"
#include "io/layout.hpp"
#include "io/output_file.hpp"
#include "io/trajectory_header.hpp"

#include <memory>
#include <string>

namespace clack {

class TrajectoryReader;

/// One run's file. What is added waits in memory until the next flush, which also writes where the
/// run can go on. The file has a temporary name until it is first whole: the first flush opens it
/// to readers and moves it into place, replacing what stood there. Every member throws WriteError,
/// naming the file, when the file cannot be written; the file then stays as its last flush left it.
class TrajectoryWriter {
public:
    TrajectoryWriter(std::string const& path, TrajectoryHeader const& header);

    /// What an earlier file of the same run holds up to `point`, of the samples only those given.
    void copy_from(TrajectoryReader const& source, ResumePoint const& point,
                   std::vector<Sample> const& samples);
    void add_frame(Snapshot const& frame, Sample const& sample);
    void add_sample(Sample const& sample);
    void add_event(Collision<double> const& event);

    std::uint64_t frames() const { return frames_; }
    std::uint64_t samples() const { return samples_; }
    std::uint64_t events() const { return events_; }

    /// Hands everything to the system, and then `point`, whose row counts it fills in.
    void flush(ResumePoint& point);
    /// After a last flush: an ordinary file again.
    void close();
    /// Takes the file away.
    void discard() noexcept;

private:
    template <class Task> void guarded(Task const& task);
    void write_waiting();
    void write_checkpoint(ResumePoint& point);

    std::string path_;
    std::unique_ptr<TemporaryName> temporary_;
    WriterLock lock_;
    hdf5::Id file_;
    FrameSeries frame_series_;
    SampleSeries sample_series_;
    std::optional<EventSeries> event_series_;
    CheckpointSlots checkpoints_;
    std::uint64_t frames_ = 0, samples_ = 0, events_ = 0;
};

} // namespace clack
