#pragma once
// What each ball has been through since time 0, told by the collisions.

#include "simulation/engine.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace clack::view {

/// Where the path of a ball bends: its place and velocity as a collision left them.
struct Bend {
    double time;
    Eigen::Vector3d place, velocity;
};

/// What a ball has been through. Side by side: a collision touches one cache line of each ball.
struct Past {
    double last_time = -std::numeric_limits<double>::infinity(); // of its last collision
    std::uint32_t collisions = 0;                                // with balls and with walls
};

class History final : public CollisionObserver {
public:
    explicit History(std::int64_t count = 0) : pasts_(static_cast<std::size_t>(count)) {}

    void operator()(Collision<double> const& collision) override;

    std::vector<Past> const& pasts() const { return pasts_; } // of each ball
    /// Collisions seen, of both kinds, and the time of the last.
    std::uint64_t total() const { return total_; }
    double last_time() const { return last_time_; }

    /// From now on one ball's path is kept, or, without a start, that it is followed; -1 for none.
    void trace(std::int64_t ball, std::optional<Bend> const& start);
    std::int64_t traced() const { return traced_; }
    std::vector<Bend> const& path() const { return path_; }

private:
    void take_part(std::int64_t ball, double time);
    void bend(Bend const& bend);

    std::vector<Past> pasts_;
    std::uint64_t total_ = 0;
    double last_time_ = -std::numeric_limits<double>::infinity();
    std::int64_t traced_ = -1;
    std::vector<Bend> path_; // the latest bends
};

} // namespace clack::view
