#pragma once
// What each ball has been through since time 0, told by the collisions.

#include "simulation/engine.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace clack::view {

/// Where the path of a ball bends: its place and velocity as a collision left them.
struct Bend {
    double time;
    Eigen::Vector3d place, velocity;
};

class History final : public CollisionObserver {
public:
    explicit History(std::int64_t count = 0)
        : collisions_(static_cast<std::size_t>(count), 0),
          last_times_(static_cast<std::size_t>(count), -std::numeric_limits<double>::infinity()) {}

    void operator()(Collision<double> const& collision) override;

    /// Number of collisions of each ball, with balls and with walls.
    std::vector<std::uint32_t> const& collisions() const { return collisions_; }
    /// Time of each ball's last collision; minus infinity before its first.
    std::vector<double> const& last_times() const { return last_times_; }
    /// Collisions seen, of both kinds, and the time of the last.
    std::uint64_t total() const { return total_; }
    double last_time() const { return last_time_; }

    /// From now on one ball's path is kept; -1 for none.
    void trace(std::int64_t ball, Bend const& start);
    std::int64_t traced() const { return traced_; }
    std::vector<Bend> const& path() const { return path_; }

private:
    void take_part(std::int64_t ball, double time);
    void bend(Bend const& bend);

    std::vector<std::uint32_t> collisions_;
    std::vector<double> last_times_;
    std::uint64_t total_ = 0;
    double last_time_ = -std::numeric_limits<double>::infinity();
    std::int64_t traced_ = -1;
    std::vector<Bend> path_; // the latest bends
};

} // namespace clack::view
