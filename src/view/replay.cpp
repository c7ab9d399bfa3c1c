#include "view/replay.hpp"

#include "io/file_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace clack::view {

Replay::Replay(std::string const& path) : path_(path) {
    open();
    start_places_ = file_->snapshot(0).positions;
    history_ = History(has_events() ? system().count : 0);
    show_frame(0);
}

/// A file may hold a million frames: what is not shown is not read.
void Replay::open() {
    file_ = std::make_unique<TrajectoryReader>(path_);
    if (file_->frame_count() == 0) {
        throw InputError(path_ + ": holds no frame yet, its run is still equilibrating; look again "
                                 "later, or view its scene");
    }
    system_ = file_->header().system;
    growing_ = file_->left_open();
    has_events_ = file_->header().events == Events::stored;
    frame_count_ = file_->frame_count();
    first_time_ = file_->frame_time(0);
    last_time_ = file_->frame_time(frame_count_ - 1);
}

/// HDF5 shows what a file held when it was first opened until it is closed.
void Replay::refresh() {
    if (!may_grow()) return;
    file_.reset();
    try {
        open();
    } catch (FileError const&) { // its writer is in the middle of something: next time
        file_.reset();
    }
}

/// The last frame for which `later` is false, by bisection; 0 when it is true for all.
template <class Later> std::size_t Replay::last_frame_before(Later const& later) const {
    std::size_t low = 0, high = frame_count_;
    while (high - low > 1) {
        auto const middle = low + (high - low) / 2;
        (later(middle) ? high : low) = middle;
    }
    return low;
}

std::size_t Replay::frame_at(double time) const {
    if (!file_) return frame_;
    auto const later = [&](std::size_t frame) { return file_->frame_time(frame) > time; };
    bool const still_here = !later(frame_) && (frame_ + 1 == frame_count_ || later(frame_ + 1));
    return still_here ? frame_ : last_frame_before(later);
}

std::size_t Replay::events_until(std::size_t frame) const {
    auto const tallies = file_->frame_sample(frame).tallies;
    return static_cast<std::size_t>(tallies.ball_collisions + tallies.wall_collisions);
}

void Replay::show_frame(std::size_t frame) {
    if (!file_) return;
    frame_ = frame;
    sample_ = file_->frame_sample(frame);
    time_ = file_->frame_time(frame);
    flights_ = file_->snapshot(frame);
    since_.assign(static_cast<std::size_t>(system().count), time_);
    met_ = sample_.tallies;
    next_event_ = events_until(frame);
}

/// An event of the file, with the times of the others near it read at once.
Collision<double> const* Replay::event(std::size_t index) {
    constexpr std::size_t at_once = 8192;
    if (!file_ || index >= file_->event_count()) return nullptr;
    if (index < window_begin_ || index >= window_begin_ + window_.size()) {
        window_begin_ = index;
        window_ = file_->events(index, std::min(at_once, file_->event_count() - index));
    }
    return &window_[index - window_begin_];
}

void Replay::fly_to(std::int64_t ball, double time) {
    auto& since = since_[static_cast<std::size_t>(ball)];
    flights_.positions.col(ball) += flights_.velocities.col(ball) * (time - since);
    since = time;
}

/// A file tells who collided and how fast they left; where, their flights do.
void Replay::take_event(Collision<double> event) {
    fly_to(event.first, event.time);
    flights_.velocities.col(event.first) = event.velocity_first;
    event.position = wrapped(flights_.positions.col(event.first));
    if (event.kind == CollisionKind::ball) {
        fly_to(event.second, event.time);
        flights_.velocities.col(event.second) = event.velocity_second;
        event.separation = wrapped(flights_.positions.col(event.second)) - event.position;
    }
    history_(event);
    ++(event.kind == CollisionKind::ball ? met_.ball_collisions : met_.wall_collisions);
    ++next_event_;
    time_ = event.time;
}

Eigen::Vector3d Replay::wrapped(Eigen::Vector3d place) const {
    if (system().boundary == Boundary::walls) return place;
    for (double& x : place) x -= std::floor(x / system().side) * system().side;
    return place;
}

Progress Replay::advance(double until) {
    until = std::min(until, last_time());
    if (!has_events()) {
        if (frame_at(until) != frame_) show_frame(frame_at(until));
        return Progress::arrived;
    }
    constexpr int events_max = 50'000;
    for (int events = 0; events < events_max; ++events) {
        auto const* const next = event(next_event_);
        if (!next || next->time > until) {
            time_ = std::max(time_, until);
            pass_frames();
            return Progress::arrived;
        }
        take_event(*next);
    }
    return Progress::under_way;
}

void Replay::pass_frames() {
    if (frame_at(time_) == frame_ || !file_) return;
    frame_ = frame_at(time_);
    sample_ = file_->frame_sample(frame_);
}

/// What balls have been through is told from the first event on.
void Replay::rewind_to(std::size_t frame) {
    auto const traced = history_.traced();
    history_ = History(system().count);
    show_frame(0);
    if (traced >= 0) trace(traced);
    if (!file_) return;
    auto const wanted = events_until(frame);
    while (next_event_ < wanted) take_event(*event(next_event_));
    show_frame(frame); // the stored places, free of what rounding adds up
}

void Replay::seek(double to) {
    to = std::clamp(to, first_time(), last_time());
    if (has_events() && to < time_) rewind_to(frame_at(to));
    while (advance(to) != Progress::arrived) {
    }
}

bool Replay::step() {
    if (!has_events()) {
        if (frame_ + 1 >= frame_count_) return false;
        show_frame(frame_ + 1);
        return true;
    }
    auto const* const next = event(next_event_);
    if (!next) return false;
    take_event(*next);
    pass_frames();
    return true;
}

bool Replay::step_back() {
    if (!has_events()) {
        if (frame_ == 0) return false;
        show_frame(frame_ - 1);
        return true;
    }
    if (next_event_ == 0 || !file_) return false;
    auto const wanted = next_event_ - (history_.last_time() >= time_ ? 1 : 0);
    rewind_to(last_frame_before([&](std::size_t frame) { return events_until(frame) > wanted; }));
    while (next_event_ < wanted) take_event(*event(next_event_));
    if (wanted > 0)
        time_ = event(wanted - 1)->time;
    else
        time_ = first_time();
    pass_frames();
    return true;
}

Snapshot Replay::snapshot() const {
    Snapshot now = flights_;
    now.time = time_;
    for (Eigen::Index ball = 0; ball < now.positions.cols(); ++ball) {
        double const flown = time_ - since_[static_cast<std::size_t>(ball)];
        now.positions.col(ball) =
            wrapped(now.positions.col(ball) + flown * now.velocities.col(ball));
    }
    return now;
}

/// How often balls met is known at each moment, where the file tells it; all else at its frames.
Sample Replay::sample() const {
    Sample now = sample_;
    if (!has_events()) return now;
    now.tallies.ball_collisions = met_.ball_collisions;
    now.tallies.wall_collisions = met_.wall_collisions;
    return now;
}

/// Without collisions nobody knows the path between the frames.
void Replay::trace(std::int64_t ball) {
    bool const is_one = ball >= 0 && ball < system().count;
    std::optional<Bend> start;
    if (is_one && has_events()) {
        auto const now = snapshot();
        start = Bend{time_, now.positions.col(ball), now.velocities.col(ball)};
    }
    history_.trace(is_one ? ball : -1, start);
}

std::optional<NextCollision> Replay::next_collision(std::optional<std::int64_t> ball) {
    if (!has_events()) return std::nullopt;
    constexpr std::size_t look_ahead = 200'000;
    for (std::size_t index = next_event_; index < next_event_ + look_ahead; ++index) {
        auto const* const next = event(index);
        if (!next) break;
        bool const of_balls = next->kind == CollisionKind::ball;
        if (!ball || next->first == *ball || (of_balls && next->second == *ball))
            return NextCollision{next->time, next->first, of_balls ? next->second : -1};
    }
    return std::nullopt;
}

/// The file has one reader, which is asked here and now.
Source::Search Replay::search(std::optional<std::int64_t> ball) {
    return [found = next_collision(ball)] { return found; };
}

std::string Replay::description() const {
    return fmt::format("{}, frame {} of {}{}{}", std::filesystem::path(path_).filename().string(),
                       frame_ + 1, frame_count_, has_events() ? ", every collision" : "",
                       may_grow() ? ", being written" : "");
}

std::string Replay::remark() const {
    if (has_events()) return {};
    return "no collisions in the file: shown from frame to frame, each at its own time";
}

} // namespace clack::view
