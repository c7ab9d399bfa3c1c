#include "view/history.hpp"

namespace clack::view {

void History::operator()(Collision<double> const& collision) {
    ++total_;
    last_time_ = collision.time;
    take_part(collision.first, collision.time);
    bool const of_balls = collision.kind == CollisionKind::ball;
    if (of_balls) take_part(collision.second, collision.time);
    if (traced_ < 0) return;
    if (collision.first == traced_) {
        bend({collision.time, collision.position, collision.velocity_first});
    } else if (of_balls && collision.second == traced_) {
        bend(
            {collision.time, collision.position + collision.separation, collision.velocity_second});
    }
}

void History::take_part(std::int64_t ball, double time) {
    Past& past = pasts_[static_cast<std::size_t>(ball)];
    ++past.collisions;
    past.last_time = time;
}

void History::bend(Bend const& bend) {
    constexpr std::size_t bends_max = 400; // more would be a tangle
    if (path_.size() >= bends_max) path_.erase(path_.begin(), path_.begin() + bends_max / 4);
    path_.push_back(bend);
}

void History::trace(std::int64_t ball, std::optional<Bend> const& start) {
    traced_ = ball;
    path_.clear();
    if (ball >= 0 && start) path_.push_back(*start);
}

} // namespace clack::view
