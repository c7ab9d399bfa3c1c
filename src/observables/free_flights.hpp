#pragma once
// The flights of balls between their collisions with one another.

#include "simulation/engine.hpp"
#include "state/snapshot.hpp"

#include <cstdint>
#include <vector>

namespace clack {

/// One ball from one ball-ball collision of its to the next; a wall turns it but does not end it.
struct FreeFlight {
    double time;   // [time]
    double length; // of the path [length]
};

/// Collects the flights that end while it watches. A ball's first collision under its eyes begins
/// its first flight, so let it watch for some collisions per ball and `forget` before what counts:
/// otherwise long flights, whose beginning it more likely missed, come too seldom.
class FreeFlights : public CollisionObserver {
public:
    explicit FreeFlights(std::int64_t count) : last_(static_cast<std::size_t>(count)) {}

    void operator()(Collision<double> const& collision) override {
        if (collision.kind != CollisionKind::ball) return;
        land(collision.first, collision.time, collision.velocity_first.norm());
        land(collision.second, collision.time, collision.velocity_second.norm());
    }

    /// Drops the flights so far; those in progress go on.
    void forget() { flights_.clear(); }
    std::vector<FreeFlight> const& flights() const { return flights_; }

private:
    struct Departure {
        double time = 0;
        double speed = -1; // none yet
    };

    void land(std::int64_t const ball, double const time, double const speed_after) {
        Departure& departure = last_[static_cast<std::size_t>(ball)];
        if (departure.speed >= 0) {
            double const wait = time - departure.time;
            flights_.push_back({wait, wait * departure.speed});
        }
        departure = {time, speed_after};
    }

    std::vector<Departure> last_;
    std::vector<FreeFlight> flights_;
};

} // namespace clack
