#include "observables/event_replay.hpp"

#include <Eigen/Geometry>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace clack {

namespace {

std::string in_words(Collision<double> const& event) {
    return fmt::format("{} {} with {} {} at t = {:.17g}", "ball", event.first,
                       event.kind == CollisionKind::ball ? "ball" : "wall", event.second,
                       event.time);
}

} // namespace

EventReplay::EventReplay(System const& system, double epoch_length, double unit_roundoff,
                         Snapshot const& first)
    : system_(system), epoch_length_(epoch_length), unit_roundoff_(unit_roundoff),
      flights_(static_cast<std::size_t>(system.count)), frame_time_(first.time) {
    for (std::size_t i = 0; i < flights_.size(); ++i) {
        flights_[i].place = first.positions.col(static_cast<Eigen::Index>(i));
        flights_[i].velocity = first.velocities.col(static_cast<Eigen::Index>(i));
        fastest_ = std::max(fastest_, flights_[i].velocity.norm());
    }
}

void EventReplay::add_event(Collision<double> const& event) {
    if (!numbers_make_sense(event)) {
        findings_.order.note(1, 0, [&] { return in_words(event) + ": there are no such balls"; });
        return;
    }
    check_order(event);
    // Epochs first: their difference is exact however old the run is.
    double const time =
        (static_cast<double>(event.epoch) * epoch_length_ - frame_time_) + event.offset;
    if (event.kind == CollisionKind::ball) {
        check_balls(event, time);
        ++ball_collisions_;
    } else {
        check_wall(event, time);
        ++wall_collisions_;
    }
    fastest_ = std::max({fastest_, event.velocity_first.norm(), event.velocity_second.norm()});
    previous_ = event;
    has_previous_ = true;
}

bool EventReplay::numbers_make_sense(Collision<double> const& event) const {
    bool const ball = event.kind == CollisionKind::ball;
    bool const wall = event.kind == CollisionKind::wall && system_.boundary == Boundary::walls;
    return (ball || wall) && event.first >= 0 && event.second >= 0 && event.first < system_.count &&
           event.second < (ball ? system_.count : 6) && (wall || event.first < event.second);
}

void EventReplay::check_order(Collision<double> const& event) {
    auto const moment = [](auto const& e) { return std::tuple(e.epoch, e.offset); };
    auto const rank = [](auto const& e) { return std::tuple(e.kind, e.first, e.second); };
    auto const here = [&] { return in_words(event) + " comes after " + in_words(previous_); };
    auto const takes_part_now = [&](std::int64_t ball) {
        return flight_of(ball).last_instant == instant_;
    };
    if (has_previous_ && moment(event) < moment(previous_)) findings_.order.note(2, 1, here);
    if (!has_previous_ || moment(event) != moment(previous_)) ++instant_;
    bool const caused_now = takes_part_now(event.first) ||
                            (event.kind == CollisionKind::ball && takes_part_now(event.second));
    if (has_previous_ && moment(event) == moment(previous_) && rank(event) <= rank(previous_) &&
        !caused_now) {
        findings_.order.note(2, 1, here);
    }
    flight_of(event.first).last_instant = instant_;
    if (event.kind == CollisionKind::ball) flight_of(event.second).last_instant = instant_;
}

void EventReplay::check_balls(Collision<double> const& event, double time) {
    auto& first = flight_of(event.first);
    auto& second = flight_of(event.second);
    fly_to(first, time);
    fly_to(second, time);
    Eigen::Vector3d const separation = nearest(second.place - first.place);
    double const distance = separation.norm();
    auto const here = [&] { return in_words(event); };
    double const rounding = rounding_of_place(first) + rounding_of_place(second);
    findings_.contact.note(std::abs(distance - system_.diameter), rounding, [&] {
        return fmt::format("{}: centres {:.17g} apart", in_words(event), distance);
    });

    Eigen::Vector3d const gain_first = event.velocity_first - first.velocity;
    Eigen::Vector3d const gain_second = event.velocity_second - second.velocity;
    double const speed = first.velocity.norm() + second.velocity.norm();
    double const along = 16 * unit_roundoff_ * speed;
    findings_.exchange.note((gain_first + gain_second).norm(), along, here);
    double const energy = first.velocity.squaredNorm() + second.velocity.squaredNorm();
    double const energy_after =
        event.velocity_first.squaredNorm() + event.velocity_second.squaredNorm();
    findings_.exchange.note(std::abs(energy_after - energy), along * speed, here);
    // What is exchanged lies along the line of centres, as well as the places tell that line.
    Eigen::Vector3d const across = gain_second.cross(separation / distance);
    findings_.exchange.note(across.norm(), along + gain_second.norm() * rounding / distance, here);
    double const receding =
        (event.velocity_second - event.velocity_first).dot(separation) / distance;
    findings_.exchange.note(-receding, along + speed * rounding / distance, here);

    first.velocity = event.velocity_first;
    second.velocity = event.velocity_second;
    ++first.collisions;
    ++second.collisions;
}

void EventReplay::check_wall(Collision<double> const& event, double time) {
    auto& ball = flight_of(event.first);
    fly_to(ball, time);
    auto const axis = static_cast<Eigen::Index>(event.second / 2);
    double const radius = system_.diameter / 2;
    double const plane = event.second % 2 == 0 ? radius : system_.side - radius;
    findings_.contact.note(std::abs(ball.place[axis] - plane), rounding_of_place(ball), [&] {
        return fmt::format("{}: centre at {:.17g}, its plane at {:.17g}", in_words(event),
                           ball.place[axis], plane);
    });
    Eigen::Vector3d mirrored = ball.velocity;
    mirrored[axis] = -mirrored[axis];
    findings_.exchange.note((event.velocity_first - mirrored).norm(), 0,
                            [&] { return in_words(event); });
    ball.place[axis] = plane;
    ball.velocity = event.velocity_first;
    ++ball.collisions;
}

void EventReplay::add_frame(Snapshot const& frame) {
    double const time = frame.time - frame_time_;
    for (std::size_t i = 0; i < flights_.size(); ++i) {
        auto& flight = flights_[i];
        auto const column = static_cast<Eigen::Index>(i);
        fly_to(flight, time);
        auto const here = [&] { return fmt::format("ball {} at t = {:.17g}", i, frame.time); };
        Eigen::Vector3d const place = frame.positions.col(column);
        findings_.frames.note(nearest(place - flight.place).norm(), 2 * rounding_of_place(flight),
                              here);
        findings_.frames.note((frame.velocities.col(column) - flight.velocity).norm(), 0, here);
        flight.place = place;
        flight.velocity = frame.velocities.col(column);
        flight.time = 0;
        flight.collisions = 0;
    }
    frame_time_ = frame.time;
}

void EventReplay::fly_to(Flight& flight, double time) {
    flight.place += flight.velocity * (time - flight.time);
    flight.time = time;
}

/// Each flight adds the roundings of a place, of a time and of their product; eight are allowed,
/// and they are added up as if all went one way (a twentieth of that was seen).
double EventReplay::rounding_of_place(Flight const& flight) const {
    double const age = std::abs(frame_time_) + std::abs(flight.time) + epoch_length_;
    double const one = 8 * unit_roundoff_ * (system_.side + fastest_ * age);
    return one * static_cast<double>(1 + flight.collisions);
}

Eigen::Vector3d EventReplay::nearest(Eigen::Vector3d separation) const {
    if (system_.boundary == Boundary::periodic) {
        for (double& along : separation) along -= system_.side * std::round(along / system_.side);
    }
    return separation;
}

} // namespace clack
