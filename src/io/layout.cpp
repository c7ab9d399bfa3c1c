#include "io/layout.hpp"

#include "io/hdf5_attributes.hpp"

#include <algorithm>
#include <array>

namespace clack {

namespace {

using hdf5::Id;

template <class Number> std::span<Number const> numbers(auto const& matrix) {
    return {matrix.data(), static_cast<std::size_t>(matrix.size())};
}

/// An element of H5MD: a group that holds `value`, and the steps and times of `clock`.
Id create_element(Id const& parent, std::string const& name, Id const& clock) {
    auto element = hdf5::create_group(parent, name);
    hdf5::hard_link(clock, "step", element, "step");
    hdf5::hard_link(clock, "time", element, "time");
    return element;
}

constexpr char const* balls_path = "particles/balls";

} // namespace

template <class Visit> void TallySeries::each(Visit const& visit) {
    visit("ball_collisions", ball_collisions_);
    visit("wall_collisions", wall_collisions_);
    visit("virial", virial_);
    visit("wall_impulse", wall_impulse_);
    visit("kinetic_energy", kinetic_energy_);
    visit("deepest_overlap", deepest_overlap_);
}

TallySeries TallySeries::create(Id const& group, Form form) {
    TallySeries tallies;
    tallies.each([&]<class Number>(char const* name, hdf5::Series<Number>& series) {
        series = form == Form::plain
                     ? hdf5::Series<Number>::create(group, name)
                     : hdf5::Series<Number>::create(hdf5::create_group(group, name), "value");
    });
    return tallies;
}

TallySeries TallySeries::open(Id const& group, Form form) {
    TallySeries tallies;
    std::string const suffix = form == Form::plain ? "" : "/value";
    tallies.each([&]<class Number>(char const* name, hdf5::Series<Number>& series) {
        series = hdf5::Series<Number>::open(group, name + suffix);
    });
    return tallies;
}

void TallySeries::push(Sample const& sample) {
    ball_collisions_.push(sample.tallies.ball_collisions);
    wall_collisions_.push(sample.tallies.wall_collisions);
    virial_.push(sample.tallies.virial);
    wall_impulse_.push(sample.tallies.wall_impulse);
    kinetic_energy_.push(sample.kinetic_energy);
    deepest_overlap_.push(sample.tallies.deepest_overlap);
}

void TallySeries::write_waiting() {
    each([](char const*, auto& series) { series.write_waiting(); });
}

void TallySeries::copy_from(TallySeries const& source, std::size_t rows) {
    ball_collisions_.copy_from(source.ball_collisions_, rows);
    wall_collisions_.copy_from(source.wall_collisions_, rows);
    virial_.copy_from(source.virial_, rows);
    wall_impulse_.copy_from(source.wall_impulse_, rows);
    kinetic_energy_.copy_from(source.kinetic_energy_, rows);
    deepest_overlap_.copy_from(source.deepest_overlap_, rows);
}

std::size_t TallySeries::rows() const {
    return std::min({ball_collisions_.rows(), wall_collisions_.rows(), virial_.rows(),
                     wall_impulse_.rows(), kinetic_energy_.rows(), deepest_overlap_.rows()});
}

std::vector<Sample> TallySeries::read(std::size_t first, std::size_t rows) const {
    auto const ball_collisions = ball_collisions_.read(first, rows);
    auto const wall_collisions = wall_collisions_.read(first, rows);
    auto const virial = virial_.read(first, rows);
    auto const wall_impulse = wall_impulse_.read(first, rows);
    auto const kinetic_energy = kinetic_energy_.read(first, rows);
    auto const deepest_overlap = deepest_overlap_.read(first, rows);
    std::vector<Sample> samples(rows);
    for (std::size_t k = 0; k < rows; ++k) {
        samples[k].tallies = {ball_collisions[k], wall_collisions[k], virial[k], wall_impulse[k],
                              deepest_overlap[k]};
        samples[k].kinetic_energy = kinetic_energy[k];
    }
    return samples;
}

FrameSeries FrameSeries::create(Id const& file, System const& system) {
    FrameSeries frames;
    frames.side_ = system.side;
    std::vector<hsize_t> const per_ball{static_cast<hsize_t>(system.count), 3};
    bool const periodic = system.boundary == Boundary::periodic;

    auto const particles = hdf5::create_group(file, "particles");
    auto const balls = hdf5::create_group(particles, "balls");
    auto const position = hdf5::create_group(balls, "position");
    frames.step_ = hdf5::Series<std::int64_t>::create(position, "step");
    frames.time_ = hdf5::Series<double>::create(position, "time");
    frames.position_ = hdf5::Series<double>::create(position, "value", per_ball);
    frames.velocity_ = hdf5::Series<double>::create(create_element(balls, "velocity", position),
                                                    "value", per_ball);
    if (periodic) {
        frames.image_ = hdf5::Series<std::int32_t>::create(create_element(balls, "image", position),
                                                           "value", per_ball);
    }
    auto const box = hdf5::create_group(balls, "box");
    hdf5::write_attribute(box, "dimension", std::vector<int>{3});
    hdf5::write_attribute(box, "boundary",
                          std::vector<std::string>(3, periodic ? "periodic" : "none"));
    frames.edges_ =
        hdf5::Series<double>::create(create_element(box, "edges", position), "value", {3, 3});

    auto const observables = hdf5::create_group(file, "observables");
    frames.tallies_ = TallySeries::create(observables, TallySeries::Form::element);
    for (auto const& name : hdf5::children(observables)) {
        auto const element = hdf5::open_group(observables, name);
        hdf5::hard_link(position, "step", element, "step");
        hdf5::hard_link(position, "time", element, "time");
    }
    return frames;
}

FrameSeries FrameSeries::open(Id const& file) {
    FrameSeries frames;
    auto const balls = hdf5::open_group(file, balls_path);
    frames.position_ = hdf5::Series<double>::open(balls, "position/value");
    frames.step_ = hdf5::Series<std::int64_t>::open(balls, "position/step");
    frames.time_ = hdf5::Series<double>::open(balls, "position/time");
    frames.velocity_ = hdf5::Series<double>::open(balls, "velocity/value");
    frames.edges_ = hdf5::Series<double>::open(balls, "box/edges/value");
    if (hdf5::exists(balls, "image")) {
        frames.image_ = hdf5::Series<std::int32_t>::open(balls, "image/value");
    }
    frames.tallies_ =
        TallySeries::open(hdf5::open_group(file, "observables"), TallySeries::Form::element);
    return frames;
}

void FrameSeries::push(Snapshot const& frame, Sample const& sample) {
    position_.push(numbers<double>(frame.positions));
    velocity_.push(numbers<double>(frame.velocities));
    if (image_) image_.push(numbers<std::int32_t>(frame.images));
    push_small(frame, sample);
}

/// All that does not grow with the number of balls.
void FrameSeries::push_small(Snapshot const& frame, Sample const& sample) {
    std::array<double, 9> const edges{side_, 0, 0, 0, side_, 0, 0, 0, side_};
    edges_.push(edges);
    step_.push(static_cast<std::int64_t>(frame.ball_collisions));
    time_.push(frame.time);
    tallies_.push(sample);
}

std::size_t FrameSeries::waiting_bytes() const {
    return position_.waiting_bytes() + velocity_.waiting_bytes() + image_.waiting_bytes();
}

void FrameSeries::write_waiting() {
    velocity_.write_waiting();
    if (image_) image_.write_waiting();
    edges_.write_waiting();
    tallies_.write_waiting();
    step_.write_waiting();
    time_.write_waiting();
    position_.write_waiting();
}

void FrameSeries::write(Snapshot const& frame, Sample const& sample) {
    write_waiting();
    velocity_.write(numbers<double>(frame.velocities));
    if (image_) image_.write(numbers<std::int32_t>(frame.images));
    push_small(frame, sample);
    write_waiting();
    position_.write(numbers<double>(frame.positions));
}

void FrameSeries::copy_from(FrameSeries const& source, std::size_t rows) {
    velocity_.copy_from(source.velocity_, rows);
    if (image_) image_.copy_from(source.image_, rows);
    edges_.copy_from(source.edges_, rows);
    tallies_.copy_from(source.tallies_, rows);
    step_.copy_from(source.step_, rows);
    time_.copy_from(source.time_, rows);
    position_.copy_from(source.position_, rows);
}

std::size_t FrameSeries::rows() const {
    auto const rows = std::min({position_.rows(), velocity_.rows(), edges_.rows(), step_.rows(),
                                time_.rows(), tallies_.rows()});
    return image_ ? std::min(rows, image_.rows()) : rows;
}

double FrameSeries::time(std::size_t frame) const { return time_.read(frame, 1).front(); }

Snapshot FrameSeries::snapshot(std::size_t frame) const {
    auto const count = static_cast<Eigen::Index>(position_.row_shape().at(0));
    Snapshot snapshot;
    snapshot.time = time(frame);
    snapshot.ball_collisions = static_cast<std::uint64_t>(step_.read(frame, 1).front());
    snapshot.positions.resize(3, count);
    snapshot.velocities.resize(3, count);
    snapshot.images.setZero(3, count);
    position_.read_into(frame, 1, snapshot.positions.data());
    velocity_.read_into(frame, 1, snapshot.velocities.data());
    if (image_) image_.read_into(frame, 1, snapshot.images.data());
    return snapshot;
}

Sample FrameSeries::sample(std::size_t frame) const {
    auto sample = tallies_.read(frame, 1).front();
    sample.time = time(frame);
    return sample;
}

SampleSeries SampleSeries::create(Id const& file) {
    SampleSeries samples;
    auto const group = hdf5::create_group(file, "samples");
    samples.time_ = hdf5::Series<double>::create(group, "time");
    samples.tallies_ = TallySeries::create(group, TallySeries::Form::plain);
    return samples;
}

SampleSeries SampleSeries::open(Id const& file) {
    SampleSeries samples;
    auto const group = hdf5::open_group(file, "samples");
    samples.time_ = hdf5::Series<double>::open(group, "time");
    samples.tallies_ = TallySeries::open(group, TallySeries::Form::plain);
    return samples;
}

void SampleSeries::push(Sample const& sample) {
    time_.push(sample.time);
    tallies_.push(sample);
}

void SampleSeries::write_waiting() {
    tallies_.write_waiting();
    time_.write_waiting();
}

std::size_t SampleSeries::rows() const { return std::min(time_.rows(), tallies_.rows()); }

std::vector<Sample> SampleSeries::read(std::size_t rows) const {
    auto samples = tallies_.read(0, rows);
    auto const times = time_.read(0, rows);
    for (std::size_t k = 0; k < rows; ++k) samples[k].time = times[k];
    return samples;
}

} // namespace clack
