#include "io/layout.hpp"

#include "io/hdf5_attributes.hpp"

#include <algorithm>

namespace clack {

using hdf5::Id;

EventSeries EventSeries::create(Id const& file) {
    EventSeries events;
    auto const group = hdf5::create_group(file, "events");
    events.time_ = hdf5::Series<double>::create(group, "time");
    events.epoch_ = hdf5::Series<std::int64_t>::create(group, "epoch");
    events.offset_ = hdf5::Series<double>::create(group, "offset");
    events.kind_ = hdf5::Series<std::int8_t>::create(group, "kind");
    events.i_ = hdf5::Series<std::int64_t>::create(group, "i");
    events.j_ = hdf5::Series<std::int64_t>::create(group, "j");
    events.velocity_i_ = hdf5::Series<double>::create(group, "velocity_i", {3});
    events.velocity_j_ = hdf5::Series<double>::create(group, "velocity_j", {3});
    hdf5::write_attribute(group, "kind", std::string("1: balls i and j; 2: ball i and wall j"));
    hdf5::write_attribute(group, "wall", std::string("0..5: x-, x+, y-, y+, z-, z+"));
    hdf5::write_attribute(group, "time",
                          std::string("epoch * parameters.epoch_length + offset, rounded"));
    return events;
}

EventSeries EventSeries::open(Id const& file) {
    EventSeries events;
    auto const group = hdf5::open_group(file, "events");
    events.time_ = hdf5::Series<double>::open(group, "time");
    events.epoch_ = hdf5::Series<std::int64_t>::open(group, "epoch");
    events.offset_ = hdf5::Series<double>::open(group, "offset");
    events.kind_ = hdf5::Series<std::int8_t>::open(group, "kind");
    events.i_ = hdf5::Series<std::int64_t>::open(group, "i");
    events.j_ = hdf5::Series<std::int64_t>::open(group, "j");
    events.velocity_i_ = hdf5::Series<double>::open(group, "velocity_i");
    events.velocity_j_ = hdf5::Series<double>::open(group, "velocity_j");
    return events;
}

void EventSeries::push(Collision<double> const& event) {
    time_.push(event.time);
    epoch_.push(event.epoch);
    offset_.push(event.offset);
    kind_.push(static_cast<std::int8_t>(event.kind));
    i_.push(event.first);
    j_.push(event.second);
    velocity_i_.push(std::span<double const>(event.velocity_first.data(), 3));
    velocity_j_.push(std::span<double const>(event.velocity_second.data(), 3));
}

std::size_t EventSeries::waiting_bytes() const { return 12 * time_.waiting_bytes(); }

void EventSeries::write_waiting() {
    epoch_.write_waiting();
    offset_.write_waiting();
    kind_.write_waiting();
    i_.write_waiting();
    j_.write_waiting();
    velocity_i_.write_waiting();
    velocity_j_.write_waiting();
    time_.write_waiting();
}

void EventSeries::copy_from(EventSeries const& source, std::size_t rows) {
    epoch_.copy_from(source.epoch_, rows);
    offset_.copy_from(source.offset_, rows);
    kind_.copy_from(source.kind_, rows);
    i_.copy_from(source.i_, rows);
    j_.copy_from(source.j_, rows);
    velocity_i_.copy_from(source.velocity_i_, rows);
    velocity_j_.copy_from(source.velocity_j_, rows);
    time_.copy_from(source.time_, rows);
}

std::size_t EventSeries::rows() const {
    return std::min({time_.rows(), epoch_.rows(), offset_.rows(), kind_.rows(), i_.rows(),
                     j_.rows(), velocity_i_.rows(), velocity_j_.rows()});
}

std::vector<Collision<double>> EventSeries::read(std::size_t first, std::size_t rows) const {
    auto const time = time_.read(first, rows);
    auto const epoch = epoch_.read(first, rows);
    auto const offset = offset_.read(first, rows);
    auto const kind = kind_.read(first, rows);
    auto const i = i_.read(first, rows);
    auto const j = j_.read(first, rows);
    auto const velocity_i = velocity_i_.read(first, rows);
    auto const velocity_j = velocity_j_.read(first, rows);
    std::vector<Collision<double>> events(rows);
    for (std::size_t k = 0; k < rows; ++k) {
        auto& event = events[k];
        event.kind = static_cast<CollisionKind>(kind[k]);
        event.epoch = epoch[k];
        event.offset = offset[k];
        event.time = time[k];
        event.first = i[k];
        event.second = j[k];
        event.velocity_first = Eigen::Map<Eigen::Vector3d const>(&velocity_i[3 * k]);
        event.velocity_second = Eigen::Map<Eigen::Vector3d const>(&velocity_j[3 * k]);
        event.position.setZero();
        event.separation.setZero();
        event.impulse.setZero();
    }
    return events;
}

} // namespace clack
