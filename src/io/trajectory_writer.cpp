#include "io/trajectory_writer.hpp"

#include "io/file_errors.hpp"
#include "io/trajectory_reader.hpp"

#include <filesystem>

namespace clack {

namespace {

/// What may wait in memory before it is written without being asked for.
constexpr std::size_t waiting_bytes_max = 4u << 20;

} // namespace

template <class Task> void TrajectoryWriter::guarded(Task const& task) {
    try {
        task();
    } catch (hdf5::Error const& error) {
        hdf5::leave_files_as_they_are();
        bool const resumable = temporary_ && temporary_->in_place();
        throw WriteError(path_ + ": " + error.what() +
                         (resumable ? "; the run can be resumed from its last flush" : ""));
    }
}

TrajectoryWriter::TrajectoryWriter(std::string const& path, TrajectoryHeader const& header)
    : path_(path), temporary_(std::make_unique<TemporaryName>(path)) {
    guarded([&] {
        file_ = hdf5::create_file(temporary_->name());
        lock_ = WriterLock(temporary_->name());
        write_header(file_, header);
        frame_series_ = FrameSeries::create(file_, header.system);
        sample_series_ = SampleSeries::create(file_);
        if (header.events == Events::stored) event_series_ = EventSeries::create(file_);
        checkpoints_ = CheckpointSlots::create(file_, header.system, header.limbs);
    });
}

void TrajectoryWriter::copy_from(TrajectoryReader const& source, ResumePoint const& point,
                                 std::vector<Sample> const& samples) {
    guarded([&] {
        frame_series_.copy_from(source.frame_series(), point.frames);
        for (auto const& sample : samples) sample_series_.push(sample);
        if (event_series_) event_series_->copy_from(source.event_series(), point.events);
    });
    frames_ = point.frames;
    samples_ = samples.size();
    events_ = point.events;
}

void TrajectoryWriter::add_frame(Snapshot const& frame, Sample const& sample) {
    bool const is_large =
        static_cast<std::size_t>(frame.positions.size()) * sizeof(double) > waiting_bytes_max;
    if (is_large) {
        guarded([&] { frame_series_.write(frame, sample); });
    } else {
        frame_series_.push(frame, sample);
        if (frame_series_.waiting_bytes() > waiting_bytes_max) {
            guarded([&] { frame_series_.write_waiting(); });
        }
    }
    ++frames_;
}

void TrajectoryWriter::add_sample(Sample const& sample) {
    sample_series_.push(sample);
    ++samples_;
}

void TrajectoryWriter::add_event(Collision<double> const& event) {
    event_series_->push(event);
    ++events_;
    if (event_series_->waiting_bytes() > waiting_bytes_max) {
        guarded([&] { event_series_->write_waiting(); });
    }
}

void TrajectoryWriter::flush(ResumePoint& point) {
    bool const first = !temporary_->in_place();
    guarded([&] {
        write_waiting();
        if (first) {
            hdf5::flush_file(file_);
            hdf5::share_with_readers(file_);
        }
        write_checkpoint(point);
    });
    if (first) temporary_->move_into_place();
}

void TrajectoryWriter::write_waiting() {
    if (event_series_) event_series_->write_waiting();
    sample_series_.write_waiting();
    frame_series_.write_waiting();
}

void TrajectoryWriter::write_checkpoint(ResumePoint& point) {
    point.frames = frames_;
    point.samples = samples_;
    point.events = events_;
    auto const& name = temporary_->in_place() ? path_ : temporary_->name();
    std::error_code ignored;
    point.file_bytes = std::filesystem::file_size(name, ignored);
    checkpoints_.write(point);
}

void TrajectoryWriter::close() {
    guarded([&] {
        hdf5::flush_file(file_);
        frame_series_ = {};
        sample_series_ = {};
        event_series_.reset();
        checkpoints_ = {};
        auto const id = file_.release();
        hdf5::checked_status(H5Fclose(id), "close the file");
    });
    lock_ = {};
}

void TrajectoryWriter::discard() noexcept {
    std::error_code ignored;
    std::filesystem::remove(temporary_->in_place() ? path_ : temporary_->name(), ignored);
}

} // namespace clack
