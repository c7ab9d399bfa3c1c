#pragma once
// Where everything that grows stands in a trajectory file: the frames in the form of H5MD 1.1, the
// samples and the events in one of our own. Writer and reader share it: each name is written once.

#include "io/series.hpp"
#include "observables/pressure.hpp"
#include "resolution/collision.hpp"
#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <optional>
#include <vector>

namespace clack {

/// Counts the changes of what stands where that make older files unreadable.
constexpr int file_format = 1;

/// The tallies and the energy over time; the times stand elsewhere.
class TallySeries {
public:
    /// As H5MD's elements, NAME/value, or as plain datasets, NAME.
    enum class Form { element, plain };

    static TallySeries create(hdf5::Id const& group, Form form);
    static TallySeries open(hdf5::Id const& group, Form form);

    void push(Sample const& sample);
    void write_waiting();
    void copy_from(TallySeries const& source, std::size_t rows);
    std::size_t rows() const; // that all of them have
    std::vector<Sample> read(std::size_t first, std::size_t rows) const;

private:
    template <class Visit> void each(Visit const& visit);

    hdf5::Series<std::uint64_t> ball_collisions_, wall_collisions_;
    hdf5::Series<double> virial_, wall_impulse_, kinetic_energy_, deepest_overlap_;
};

/// The frames: `particles/balls` and `observables`.
class FrameSeries {
public:
    static FrameSeries create(hdf5::Id const& file, System const& system);
    static FrameSeries open(hdf5::Id const& file);

    void push(Snapshot const& frame, Sample const& sample);
    std::size_t waiting_bytes() const;
    /// The positions last: readers count frames by them, and find all else there already.
    void write_waiting();
    /// A frame too large to be copied first.
    void write(Snapshot const& frame, Sample const& sample);
    void copy_from(FrameSeries const& source, std::size_t rows);

    std::size_t rows() const;
    double time(std::size_t frame) const;
    Snapshot snapshot(std::size_t frame) const;
    Sample sample(std::size_t frame) const;

private:
    void push_small(Snapshot const& frame, Sample const& sample);

    double side_ = 0;
    hdf5::Series<double> position_, velocity_, edges_, time_;
    hdf5::Series<std::int32_t> image_; // periodic only
    hdf5::Series<std::int64_t> step_;
    TallySeries tallies_;
};

/// The samples: `samples`.
class SampleSeries {
public:
    static SampleSeries create(hdf5::Id const& file);
    static SampleSeries open(hdf5::Id const& file);

    void push(Sample const& sample);
    void write_waiting();
    std::size_t rows() const;
    std::vector<Sample> read(std::size_t rows) const;

private:
    hdf5::Series<double> time_;
    TallySeries tallies_;
};

/// Every collision: `events`, when asked for.
class EventSeries {
public:
    static EventSeries create(hdf5::Id const& file);
    static EventSeries open(hdf5::Id const& file);

    void push(Collision<double> const& event);
    std::size_t waiting_bytes() const;
    void write_waiting();
    void copy_from(EventSeries const& source, std::size_t rows);
    std::size_t rows() const;
    /// Without position, separation and impulse: those follow from the flights.
    std::vector<Collision<double>> read(std::size_t first, std::size_t rows) const;

private:
    hdf5::Series<double> time_, offset_, velocity_i_, velocity_j_;
    hdf5::Series<std::int64_t> epoch_, i_, j_;
    hdf5::Series<std::int8_t> kind_;
};

} // namespace clack
