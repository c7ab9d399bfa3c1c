#include "view/player.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

namespace clack::view {

namespace {

double seconds_between(std::chrono::steady_clock::time_point begin,
                       std::chrono::steady_clock::time_point end) {
    return std::chrono::duration<double>(end - begin).count();
}

/// Time of the processor that this thread has had.
double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::uint64_t collisions_of(Sample const& sample) {
    return sample.tallies.ball_collisions + sample.tallies.wall_collisions;
}

constexpr auto idle_wait = std::chrono::milliseconds(4);
// While it plays, a frame that is wanted ends the wait. Few long steps cost the engine less than
// many short ones, before each of which others have swept its balls from the caches.
constexpr auto step_wait = std::chrono::milliseconds(16);

} // namespace

Player::Player(std::unique_ptr<Source> source, double speed) : source_(std::move(source)) {
    now_.speed = speed;
    begin_anew();
    publish();
    thread_ = std::thread([this] { work(); });
}

Player::~Player() {
    {
        std::lock_guard const lock(mutex_);
        closing_ = true;
    }
    asked_.notify_all();
    thread_.join();
}

/// Another source, or its first time reached.
void Player::begin_anew() {
    start_places_ = std::make_shared<Eigen::Matrix3Xd const>(source_->start_places());
    samples_.clear();
    foresight_ = Foresight{};
    prepared_ = source_->preparation_share() >= 1;
    target_ = source_->time();
    arrived_ = true;
    last_move_ = Clock::now();
    meter_.begin(last_move_, reached(source_->sample()));
}

void Player::ask(Task task) {
    ++tasks_asked_;
    {
        std::lock_guard const lock(mutex_);
        tasks_.push_back(std::move(task));
    }
    asked_.notify_all();
}

void Player::play() {
    ask([this] {
        now_.playing = Playing::yes;
        if (source_->time() >= source_->last_time() && !source_->may_grow())
            source_->seek(source_->first_time());
        target_ = source_->time();
        last_move_ = Clock::now();
        meter_.begin(last_move_, reached(source_->sample()));
    });
}

void Player::pause() {
    ask([this] { now_.playing = Playing::no; });
}

void Player::set_speed(double speed) {
    ask([this, speed] { now_.speed = std::clamp(speed, 1e-3, 1e3); });
}

void Player::step() {
    ask([this] {
        now_.playing = Playing::no;
        if (!source_->step()) now_.message = "no further collision";
    });
}

void Player::step_back() {
    ask([this] {
        now_.playing = Playing::no;
        if (!source_->step_back()) now_.message = "no earlier collision";
    });
}

void Player::seek(double time) {
    ask([this, time] {
        source_->seek(std::clamp(time, source_->first_time(), source_->last_time()));
        target_ = source_->time();
        meter_.begin(Clock::now(), reached(source_->sample())); // a leap is no speed
    });
}

void Player::trace(std::int64_t ball) {
    ask([this, ball] { source_->trace(ball); });
}

void Player::restart(Maker maker) {
    ask([this, maker = std::move(maker)] {
        auto fresh = maker();
        source_ = std::move(fresh);
        begin_anew();
    });
}

std::shared_ptr<Shown const> Player::latest() {
    std::lock_guard const lock(mutex_);
    return shown_;
}

void Player::want_news() {
    std::lock_guard const lock(mutex_);
    wanted_ = true;
    asked_.notify_all();
}

/// What a source throws becomes the message, and the playing stops.
void Player::guarded(Task const& task) {
    try {
        now_.message.clear();
        task();
    } catch (std::exception const& error) {
        now_.message = error.what();
        now_.playing = Playing::no;
    }
    changed_ = true;
}

bool Player::take_task() {
    Task task;
    {
        std::lock_guard const lock(mutex_);
        if (tasks_.empty()) return false;
        task = std::move(tasks_.front());
        tasks_.pop_front();
    }
    guarded(task);
    ++now_.tasks_done;
    asked_since_ = true; // what was asked for is shown at once
    target_ = source_->time();
    return true;
}

void Player::work() {
    for (;;) {
        while (take_task()) {
        }
        refresh();
        if (foresight_.has_news()) changed_ = asked_since_ = true;
        if (now_.playing == Playing::yes || !prepared_) {
            auto const before = now_.message;
            guarded([&] { move(); });
            if (now_.message.empty()) now_.message = before;
        }
        std::unique_lock lock(mutex_);
        if (closing_) return;
        if (changed_ && (wanted_ || asked_since_)) {
            lock.unlock();
            publish();
            continue;
        }
        if (tasks_.empty() && (arrived_ || now_.playing == Playing::no))
            asked_.wait_for(lock, now_.playing == Playing::yes ? step_wait : idle_wait);
    }
}

/// On with the time that has passed. What the engine cannot catch up with is let go: time then
/// passes more slowly, and is shown so.
void Player::move() {
    auto const begin = Clock::now();
    if (now_.playing == Playing::yes) {
        constexpr double debt_max = 0.05; // [s]
        if (!arrived_) target_ = std::min(target_, source_->time() + debt_max * now_.speed);
        double const passed = seconds_between(last_move_, begin);
        target_ = std::min(target_ + std::min(passed, debt_max) * now_.speed, source_->last_time());
    }
    last_move_ = begin;
    constexpr double budget = 0.015; // [s] until the next look at what is asked
    double const cpu_begin = cpu_seconds();
    do {
        arrived_ = source_->advance(target_) == Progress::arrived;
    } while (!arrived_ && seconds_between(begin, Clock::now()) < budget);
    meter_.add_engine_seconds(cpu_seconds() - cpu_begin);
    if (!prepared_ && source_->preparation_share() >= 1) begin_anew();
    constexpr double sample_pause = 0.05; // [s]: Z needs many, however seldom frames are drawn
    if (seconds_between(last_sample_, Clock::now()) > sample_pause) keep_sample(source_->sample());
    if (source_->time() >= source_->last_time() && !source_->may_grow()) now_.playing = Playing::no;
}

void Player::refresh() {
    constexpr double pause = 0.5; // [s]
    if (!source_->may_grow() || seconds_between(last_refresh_, Clock::now()) < pause) return;
    last_refresh_ = Clock::now();
    source_->refresh();
    changed_ = true;
}

/// Few enough to be blocked at once; when there are more, every second one goes, and new ones come
/// as far apart as those that stay.
void Player::keep_sample(Sample const& sample) {
    constexpr std::size_t samples_max = 1024;
    last_sample_ = Clock::now();
    std::erase_if(samples_, [&](Sample const& kept) { return kept.time > sample.time; });
    if (!samples_.empty()) {
        double const apart = (samples_.back().time - samples_.front().time) / samples_max;
        if (sample.time <= samples_.back().time + apart) return;
    }
    if (samples_.size() >= samples_max) {
        std::vector<Sample> thinned;
        for (std::size_t k = 0; k < samples_.size(); k += 2) thinned.push_back(samples_[k]);
        samples_.swap(thinned);
    }
    samples_.push_back(sample);
}

/// A source that goes from frame to frame has reached the target when the next frame is later.
Meter::Reached Player::reached(Sample const& sample) const {
    double const time = arrived_ ? std::max(target_, source_->time()) : source_->time();
    return {time, collisions_of(sample)};
}

std::string Player::why_unforetold() const {
    constexpr std::int64_t at_all = 200'000;
    auto const count = source_->system().count;
    auto const* const history = source_->history();
    if (!history || history->pasts().empty()) return "not known without collisions";
    if (count > at_all) return "not foretold: too many balls";
    if (now_.playing == Playing::yes && count > few_balls) return "foretold in a pause";
    return {};
}

void Player::publish() {
    bool const in_a_hurry = asked_since_ && source_->system().count > few_balls;
    changed_ = in_a_hurry; // more will be told in the next
    asked_since_ = false;
    Frame frame = frame_of(*source_, start_places_);
    now_.unforetold = why_unforetold();
    now_.settled = !now_.unforetold.empty() || foresight_.tell(*source_, now_.tasks_done, frame);
    keep_sample(frame.sample);
    if (now_.playing == Playing::yes) {
        if (auto const rates = meter_.read(Clock::now(), reached(frame.sample)))
            now_.rates = *rates;
    }
    now_.equilibration = source_->preparation_share();
    now_.first_time = source_->first_time();
    now_.last_time = source_->last_time();
    now_.description = source_->description();
    now_.remark = source_->remark();
    constexpr double physics_pause = 0.2; // [s]
    if (!in_a_hurry && (now_.playing == Playing::no ||
                        seconds_between(last_physics_, Clock::now()) > physics_pause)) {
        now_.physics = physics_of(frame, samples_);
        last_physics_ = Clock::now();
    }
    ++now_.number;
    auto fresh = std::make_shared<Shown>(now_);
    fresh->frame = std::move(frame);
    std::lock_guard const lock(mutex_);
    shown_ = std::move(fresh);
    wanted_ = false;
}

} // namespace clack::view
