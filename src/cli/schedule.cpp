#include "cli/schedule.hpp"

#include "state/real.hpp"

#include <algorithm>
#include <cmath>

namespace clack {

namespace {

constexpr double infinity_of_time = std::numeric_limits<double>::infinity();
constexpr std::uint64_t no_count = std::numeric_limits<std::uint64_t>::max();
constexpr double samples_min = 200; // and below twice as many: blocks of all lengths, few bytes

} // namespace

Schedule::Schedule(Scene const& scene)
    : equilibration_(collisions_of(scene.equilibrate, scene.system.count)),
      frame_interval_(scene.frame_interval),
      rounding_(4 * (scene.precision == Precision::single_
                         ? static_cast<double>(unit_roundoff<float>)
                         : unit_roundoff<double>)) {
    if (scene.time) end_time_ = *scene.time;
    if (scene.collisions) end_collisions_ = *scene.collisions;
    if (scene.collisions_per_ball) {
        end_collisions_ = collisions_of(*scene.collisions_per_ball, scene.system.count);
    }
    double const whole = counts_time() ? end_time_ : static_cast<double>(end_collisions_);
    pace_ = whole > 0 ? std::exp2(std::floor(std::log2(whole / samples_min))) : 1;
    if (!counts_time()) pace_ = std::max(pace_, 1.0);
}

double Schedule::frame_time(std::uint64_t frame) const {
    if (!(frame_interval_ > 0)) return frame == 0 ? 0 : infinity_of_time;
    return static_cast<double>(frame) * frame_interval_;
}

double Schedule::sample_time(std::uint64_t sample) const {
    return counts_time() ? static_cast<double>(sample) * pace_ : infinity_of_time;
}

std::uint64_t Schedule::sample_collisions(std::uint64_t sample) const {
    return counts_time() ? no_count : sample * static_cast<std::uint64_t>(pace_);
}

Goal Schedule::next_goal(ResumePoint const& point) const {
    Goal goal;
    goal.time = std::min({frame_time(point.next_frame), sample_time(point.next_sample), end_time_});
    goal.ball_collisions = std::min(sample_collisions(point.next_sample), end_collisions_);
    return goal;
}

bool Schedule::frame_is_due(ResumePoint const& point, Goal const& goal, Stop stop) const {
    return stop == Stop::time && goal.time == frame_time(point.next_frame);
}

bool Schedule::sample_is_due(ResumePoint const& point, Goal const& goal, Stop stop) const {
    return counts_time() ? stop == Stop::time && goal.time == sample_time(point.next_sample)
                         : stop == Stop::collisions &&
                               goal.ball_collisions == sample_collisions(point.next_sample);
}

bool Schedule::is_reached(double time, std::uint64_t ball_collisions) const {
    return counts_time() ? time >= end_time_ || same_moment(time, end_time_)
                         : ball_collisions >= end_collisions_;
}

bool Schedule::same_moment(double a, double b) const {
    return std::abs(a - b) <= rounding_ * std::max(std::abs(a), std::abs(b));
}

double Schedule::progress(double time, std::uint64_t ball_collisions) const {
    double const done =
        counts_time() ? time / end_time_
                      : static_cast<double>(ball_collisions) / static_cast<double>(end_collisions_);
    return std::isfinite(done) ? std::clamp(done, 0.0, 1.0) : 1.0;
}

bool Schedule::is_on_pace(Sample const& sample) const {
    double const at =
        counts_time() ? sample.time : static_cast<double>(sample.tallies.ball_collisions);
    return same_moment(std::round(at / pace_) * pace_, at);
}

void Schedule::extend(Schedule const& old, ResumePoint& point, std::vector<Sample>& samples) const {
    point.phase = Phase::under_way;
    point.frames -= point.closing_frames;
    point.closing_frames = 0;
    samples.resize(samples.size() - point.closing_samples);
    point.closing_samples = 0;
    if (counts_time() == old.counts_time()) {
        std::erase_if(samples, [&](Sample const& sample) { return !is_on_pace(sample); });
    }
    auto const& tallies = point.engine.tallies;
    double const time = static_cast<double>(point.engine.epoch) * point.engine.epoch_length +
                        point.engine.offset.front();
    double const at = counts_time() ? time : static_cast<double>(tallies.ball_collisions);
    // One that is passed, or is now and is there already, is not taken again.
    double const nearest = std::round(at / pace_);
    double const passed = same_moment(nearest * pace_, at) ? nearest : std::floor(at / pace_);
    point.next_sample = static_cast<std::uint64_t>(passed) + 1;
    point.samples = samples.size();
}

} // namespace clack
