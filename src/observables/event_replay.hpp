#pragma once
// A run told by its events: every ball is flown straight from one to the next, and each event is
// held against the laws. Nothing of the engine's is used.

#include "resolution/collision.hpp"
#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace clack {

/// How well a law is kept: the largest departure in units of what rounding allows, and where.
struct Departure {
    double worst = 0; // 1 is the bound
    std::string where = {};

    void note(double departure, double bound, auto const& say_where) {
        double const share = bound > 0       ? departure / bound
                             : departure > 0 ? std::numeric_limits<double>::infinity()
                                             : 0;
        if (share <= worst) return; // false for not a number, which is the worst
        worst = share == share ? share : std::numeric_limits<double>::infinity();
        where = say_where();
    }
    bool is_broken() const { return !(worst <= 1); }
};

/// Feed it the first frame, then all events and frames in their order.
class EventReplay {
public:
    /// What is found out about the laws.
    struct Findings {
        Departure order;    // times never fall; at one time kind and numbers rise, but for an event
                            // that another at that time gave rise to
        Departure contact;  // balls meet at one diameter, walls at their planes
        Departure exchange; // momentum and energy of the two; only normal components change
        Departure frames;   // frames show the balls where the events take them
    };

    ///   epoch_length   of the events' clock  [time]
    ///   unit_roundoff  of the run's numbers
    EventReplay(System const& system, double epoch_length, double unit_roundoff,
                Snapshot const& first);

    void add_event(Collision<double> const& event);
    void add_frame(Snapshot const& frame);

    Findings const& findings() const { return findings_; }
    std::uint64_t ball_collisions() const { return ball_collisions_; }
    std::uint64_t wall_collisions() const { return wall_collisions_; }

private:
    struct Flight {
        Eigen::Vector3d place, velocity;
        double time = 0;                // since the last frame
        std::uint64_t collisions = 0;   // since the last frame
        std::uint64_t last_instant = 0; // the last moment at which it took part in an event
    };

    bool numbers_make_sense(Collision<double> const& event) const;
    void check_order(Collision<double> const& event);
    void check_balls(Collision<double> const& event, double time);
    void check_wall(Collision<double> const& event, double time);
    void fly_to(Flight& flight, double time);
    double rounding_of_place(Flight const& flight) const;
    Eigen::Vector3d nearest(Eigen::Vector3d separation) const;
    Flight& flight_of(std::int64_t ball) { return flights_[static_cast<std::size_t>(ball)]; }

    System system_;
    double epoch_length_, unit_roundoff_;
    std::vector<Flight> flights_;
    double frame_time_;
    double fastest_ = 0;
    Collision<double> previous_{};
    bool has_previous_ = false;
    std::uint64_t instant_ = 1; // counts the distinct moments of events
    std::uint64_t ball_collisions_ = 0, wall_collisions_ = 0;
    Findings findings_;
};

} // namespace clack
