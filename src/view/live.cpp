#include "view/live.hpp"

#include "io/trajectory_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace clack::view {

namespace {

constexpr double slice_seconds = 0.01;

/// Waits for one collision, of any ball or of one.
class NextOf final : public CollisionObserver {
public:
    explicit NextOf(std::optional<std::int64_t> ball) : ball_(ball) {}
    void operator()(Collision<double> const& collision) override {
        bool const of_balls = collision.kind == CollisionKind::ball;
        bool const is_it =
            !ball_ || collision.first == *ball_ || (of_balls && collision.second == *ball_);
        if (found || !is_it) return;
        found = NextCollision{collision.time, collision.first, of_balls ? collision.second : -1};
    }
    std::optional<NextCollision> found;

private:
    std::optional<std::int64_t> ball_;
};

std::size_t bytes_of(System const& system) { return static_cast<std::size_t>(system.count) * 96; }

} // namespace

Live::Live(Scene scene)
    : scene_(std::move(scene)),
      equilibration_(collisions_of(scene_.equilibrate, scene_.system.count)) {
    engine_ =
        make_engine(scene_.system, scene_.method, scene_.precision, make_start(scene_, last_frame));
    if (equilibration_ == 0) begin();
    start_places_ = engine_->snapshot().positions;
}

void Live::begin() {
    engine_->start_clock();
    equilibrated_ = true;
    history_ = History(engine_->system().count);
    start_places_ = engine_->snapshot().positions;
    keep();
}

double Live::preparation_share() const {
    if (equilibrated_) return 1;
    return static_cast<double>(engine_->tallies().ball_collisions) /
           static_cast<double>(equilibration_);
}

/// A slice towards the goal; the slice learns how long it should be.
Stop Live::work(Goal const& goal) {
    using Clock = std::chrono::steady_clock;
    auto const begin = Clock::now();
    Goal part = goal;
    part.events = std::min(goal.events, slice_);
    Stop const stop = engine_->advance(part, equilibrated_ ? &history_ : nullptr);
    double const seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    if (stop == Stop::events && part.events == slice_) {
        if (seconds < slice_seconds / 2) slice_ *= 2;
        if (seconds > slice_seconds * 2) slice_ = std::max<std::uint64_t>(slice_ / 2, 1);
    }
    return stop;
}

void Live::equilibrate() {
    Goal goal;
    goal.ball_collisions = equilibration_;
    Stop const stop = work(goal);
    if (stop == Stop::collisions || stop == Stop::never) begin();
}

Progress Live::advance(double until) {
    if (!equilibrated_) {
        equilibrate();
        return Progress::under_way;
    }
    if (until <= time()) return Progress::arrived;
    constexpr std::uint64_t collisions_between = 1 << 17; // fractions of a second to do again
    if (history_.total() > kept_.back().history.total() + collisions_between) keep();
    Goal goal;
    goal.time = until;
    return work(goal) == Stop::events ? Progress::under_way : Progress::arrived;
}

/// States are kept as long as they take a quarter of a GiB at most; then every second one goes.
void Live::keep() {
    constexpr std::size_t bytes_max = 256u << 20;
    auto const most = std::max<std::size_t>(bytes_max / bytes_of(engine_->system()), 2);
    if (kept_.size() >= std::min<std::size_t>(most, 200)) {
        for (std::size_t i = 1; i < kept_.size(); ++i)
            kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    kept_.push_back({engine_->time(), engine_->checkpoint(), history_});
}

template <class Before> Live::Kept const& Live::latest_kept(Before const& before) const {
    auto const found = std::find_if(kept_.rbegin(), kept_.rend(), before);
    return found == kept_.rend() ? kept_.front() : *found;
}

void Live::go_back_to(Kept const& kept) {
    engine_ = make_engine(scene_.system, scene_.method, scene_.precision, kept.checkpoint);
    auto const traced = history_.traced();
    history_ = kept.history;
    if (history_.traced() != traced) trace(traced);
}

void Live::seek(double to) {
    while (!equilibrated_) equilibrate();
    if (to < time()) {
        go_back_to(latest_kept([&](Kept const& kept) { return kept.time <= to; }));
        std::erase_if(kept_, [&](Kept const& kept) { return kept.time > time(); });
    }
    while (advance(to) != Progress::arrived) {
    }
}

bool Live::step() {
    while (!equilibrated_) equilibrate();
    constexpr int events_max = 10'000'000; // on courses that never meet there is no next collision
    auto const before = history_.total();
    Goal goal;
    goal.events = 1;
    for (int events = 0; history_.total() == before && events < events_max; ++events) {
        if (engine_->advance(goal, &history_) == Stop::never) return false;
    }
    return history_.total() > before;
}

/// Every collision is an event at least, so as many events as collisions are wanted never take the
/// engine too far.
bool Live::step_back() {
    if (!equilibrated_ || history_.total() == 0) return false;
    bool const at_collision = history_.last_time() >= time();
    auto const wanted = history_.total() - (at_collision ? 1 : 0);
    go_back_to(latest_kept(
        [&](Kept const& kept) { return kept.history.total() < wanted || kept.time <= 0; }));
    std::erase_if(kept_, [&](Kept const& kept) { return kept.time > time(); });
    while (history_.total() < wanted) {
        Goal goal;
        goal.events = wanted - history_.total();
        engine_->advance(goal, &history_);
    }
    return true;
}

Sample Live::sample() const { return {time(), engine_->tallies(), engine_->kinetic_energy()}; }

void Live::trace(std::int64_t ball) {
    if (ball < 0 || ball >= system().count) {
        history_.trace(-1, std::nullopt);
        return;
    }
    auto const now = engine_->snapshot();
    history_.trace(ball, Bend{time(), now.positions.col(ball), now.velocities.col(ball)});
}

/// A twin of the engine runs ahead and tells what it meets.
Source::Search Live::search(std::optional<std::int64_t> ball) {
    if (!equilibrated_) return [] { return std::nullopt; };
    return [ball, system = scene_.system, precision = scene_.precision,
            now = engine_->checkpoint()]() -> std::optional<NextCollision> {
        auto const ahead = make_engine(system, Method::automatic, precision, now);
        NextOf next(ball);
        // A ball's turn comes after some collisions of all others.
        auto const count = static_cast<std::uint64_t>(system.count);
        std::uint64_t const events_max =
            ball ? std::max<std::uint64_t>(20 * count, 10'000) : 100'000;
        Goal goal;
        goal.events = 16;
        for (std::uint64_t events = 0; !next.found && events < events_max; events += goal.events) {
            if (ahead->advance(goal, &next) == Stop::never) break;
        }
        return next.found;
    };
}

std::string Live::description() const {
    auto const model = engine_->model();
    return fmt::format("{}, {}, {} in {}", model.boundary, model.search, model.queue,
                       model.precision);
}

} // namespace clack::view
