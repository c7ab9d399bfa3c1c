#include "cli/recorded_run.hpp"

#include "cli/interrupt.hpp"
#include "state/errors.hpp"

#include <fmt/format.h>

#include <ctime>

#include <algorithm>
#include <utility>

namespace clack {

namespace {

/// How long the loop may be deaf to signals and clocks.
constexpr double slice_seconds = 0.02;
/// A kill loses what came since the last flush: two seconds, or a quarter of one after a frame, for
/// those who follow. Flushes take at most a twentieth of the time.
constexpr double flush_seconds_max = 2, flush_seconds_after_frame = 0.25, flush_cost_share = 20;

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double cpu_clock() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace

RecordedRun::RecordedRun(Scene const& scene, Engine& engine, TrajectoryWriter& writer,
                         ProgressLine& line, ResumePoint point, std::vector<Sample> samples)
    : scene_(scene), schedule_(scene), engine_(engine), writer_(writer), line_(line),
      point_(std::move(point)), samples_(std::move(samples)), recorder_(writer),
      watch_(engine.system(), engine.kinetic_energy(), scene.source), last_flush_(Clock::now()) {
    if (point_.next_frame > 0) last_frame_time_ = schedule_.frame_time(point_.next_frame - 1);
}

RecordedRun::End RecordedRun::run() {
    if (point_.phase == Phase::equilibrating) {
        if (schedule_.equilibration() > 0 && equilibrate() == End::interrupted) {
            return End::interrupted;
        }
        start_clock();
    }
    flush();
    return measure();
}

RecordedRun::End RecordedRun::equilibrate() {
    Goal goal;
    goal.ball_collisions = schedule_.equilibration();
    auto const share = [&] {
        return static_cast<double>(engine_.tallies().ball_collisions) /
               static_cast<double>(goal.ball_collisions);
    };
    flush();
    line_.begin("equilibrating", share(), engine_.tallies().ball_collisions);
    while (advance(goal) != Stop::collisions) {
        if (interrupt_requested()) {
            flush();
            return End::interrupted;
        }
        if (flush_is_due()) flush();
        line_.show(share(), engine_.tallies().ball_collisions);
    }
    return End::finished;
}

void RecordedRun::start_clock() {
    engine_.start_clock();
    engine_.hash_collisions();
    point_ = {};
    point_.phase = Phase::under_way;
    add_frame();
    add_sample();
}

RecordedRun::End RecordedRun::measure() {
    auto const collisions = [&] { return engine_.tallies().ball_collisions; };
    auto const share = [&] { return schedule_.progress(engine_.time(), collisions()); };
    line_.begin("running", share(), collisions());
    while (point_.phase != Phase::finished) {
        Goal const goal = schedule_.next_goal(point_);
        record(goal, advance(goal));
        if (point_.phase != Phase::finished && interrupt_requested()) {
            flush();
            return End::interrupted;
        }
        if (flush_is_due()) flush();
        line_.show(share(), collisions());
    }
    flush();
    return End::finished;
}

Stop RecordedRun::advance(Goal goal) {
    goal.events = slice_;
    auto const begin = Clock::now();
    double const cpu_begin = cpu_clock();
    bool const record_events = scene_.events == Events::stored && point_.phase == Phase::under_way;
    Stop const stop = engine_.advance(goal, record_events ? &recorder_ : nullptr);
    if (point_.phase == Phase::under_way) point_.cpu_seconds += cpu_clock() - cpu_begin;
    bool const counts_collisions = goal.ball_collisions != Goal{}.ball_collisions;
    if (stop == Stop::never) {
        throw InputError(fmt::format("the goal counts collisions, and after t = {:.6g} nothing "
                                     "will ever happen; set time instead ({})",
                                     engine_.time(), scene_.source));
    }
    if (counts_collisions) {
        watch_.look(engine_.time(), engine_.tallies().ball_collisions, writer_.frames());
    }
    if (stop == Stop::events) {
        double const seconds = seconds_since(begin);
        if (seconds < slice_seconds / 2) slice_ *= 2;
        if (seconds > slice_seconds * 2) slice_ = std::max<std::uint64_t>(slice_ / 2, 1);
    }
    return stop;
}

void RecordedRun::record(Goal const& goal, Stop stop) {
    if (schedule_.frame_is_due(point_, goal, stop)) add_frame();
    if (schedule_.sample_is_due(point_, goal, stop)) add_sample();
    bool const ended =
        (stop == Stop::time && goal.time == schedule_.end_time()) ||
        (stop == Stop::collisions && goal.ball_collisions == schedule_.end_collisions());
    if (ended) finish();
}

/// The end is stored whether a frame or a sample is due or not.
void RecordedRun::finish() {
    if (!frame_stands_here()) {
        auto const next = point_.next_frame;
        add_frame();
        point_.next_frame = next;
        point_.closing_frames = 1;
    }
    auto const& last = samples_.back();
    bool const sample_stands_here =
        last.time == engine_.time() &&
        last.tallies.ball_collisions == engine_.tallies().ball_collisions;
    if (!sample_stands_here) {
        auto const next = point_.next_sample;
        add_sample();
        point_.next_sample = next;
        point_.closing_samples = 1;
    }
    point_.phase = Phase::finished;
}

bool RecordedRun::frame_stands_here() const {
    return last_frame_time_ >= 0 && schedule_.same_moment(last_frame_time_, engine_.time());
}

void RecordedRun::add_frame() {
    writer_.add_frame(engine_.snapshot(), sample_now());
    last_frame_time_ = engine_.time();
    ++point_.next_frame;
    frame_is_new_ = true;
}

void RecordedRun::add_sample() {
    samples_.push_back(sample_now());
    writer_.add_sample(samples_.back());
    ++point_.next_sample;
}

Sample RecordedRun::sample_now() const {
    return {engine_.time(), engine_.tallies(), engine_.kinetic_energy()};
}

bool RecordedRun::flush_is_due() const {
    double const least = frame_is_new_ ? flush_seconds_after_frame : flush_seconds_max;
    return seconds_since(last_flush_) > std::max(least, flush_cost_share * flush_seconds_);
}

void RecordedRun::flush() {
    auto const begin = Clock::now();
    point_.engine = engine_.checkpoint();
    writer_.flush(point_);
    point_.engine = {}; // as large as the balls themselves
    last_flush_ = Clock::now();
    flush_seconds_ = seconds_since(begin);
    frame_is_new_ = false;
}

} // namespace clack
