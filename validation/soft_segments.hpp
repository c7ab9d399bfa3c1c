#pragma once
// Short pieces of a run, and what of them a run of soft balls can be compared with.

#include "simulation/engine.hpp"
#include "state/snapshot.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace clack::validation {

/// A collision as the mask needs it: when, and whose. `second` is ignored for a wall.
struct Meeting {
    CollisionKind kind;
    double time;
    std::int64_t first, second;
};

/// Hard balls from a start to their places a while later, with all collisions on the way.
struct Segment {
    Start start;
    double time = 0; // how long it lasts
    std::vector<Meeting> meetings;
    Snapshot end;
};

class MeetingRecorder final : public CollisionObserver {
public:
    void operator()(Collision<double> const& collision) override {
        meetings.push_back({collision.kind, collision.time, collision.first, collision.second});
    }
    std::vector<Meeting> meetings;
};

/// Flies an engine that stands at time 0 on for a while.
inline Segment fly(Engine& engine, double const time) {
    Snapshot const first = engine.snapshot();
    MeetingRecorder recorder;
    engine.advance({.time = time}, &recorder);
    return {{first.positions, first.velocities}, time, recorder.meetings, engine.snapshot()};
}

/// Which balls of a segment soft balls should follow.
struct Mask {
    std::vector<bool> kept;
    std::int64_t met = 0; // balls with a collision at all

    double kept_fraction() const {
        return static_cast<double>(std::count(kept.begin(), kept.end(), true)) /
               static_cast<double>(met);
    }
};

/// Keeps the balls that collide, and of these drops where soft balls have no limit or none yet: a
/// ball one of whose collisions lies within `span` of the segment's end, or of another of its own
/// (two walls do not mind each other: their springs push along different axes), and from then on
/// every ball that meets such a one.
inline Mask masked(Segment const& segment, double const span) {
    constexpr double never = std::numeric_limits<double>::infinity();
    struct History {
        double last_ball = -never, last_wall = -never, spoilt = never;
        bool met = false;
    };
    auto const count = static_cast<std::size_t>(segment.start.positions.cols());
    std::vector<History> histories(count);
    auto const of = [&](std::int64_t ball) -> History& {
        return histories[static_cast<std::size_t>(ball)];
    };
    // A collision spoils the one before it too, so its partner is spoilt since that one: the list
    // is gone through until nothing changes.
    bool changed = true;
    auto const spoil = [&](History& history, double const since) {
        if (!(since < history.spoilt)) return;
        history.spoilt = since;
        changed = true;
    };
    auto const look = [&](History& history, Meeting const& meeting) {
        bool const wall = meeting.kind == CollisionKind::wall;
        double const before =
            wall ? history.last_ball : std::max(history.last_ball, history.last_wall);
        if (meeting.time - before < span) spoil(history, before);
        if (segment.time - meeting.time < span) spoil(history, meeting.time);
        (wall ? history.last_wall : history.last_ball) = meeting.time;
        history.met = true;
    };
    while (changed) {
        changed = false;
        for (History& history : histories) history.last_ball = history.last_wall = -never;
        for (Meeting const& meeting : segment.meetings) {
            look(of(meeting.first), meeting);
            if (meeting.kind == CollisionKind::wall) continue;
            look(of(meeting.second), meeting);
            if (of(meeting.first).spoilt <= meeting.time) spoil(of(meeting.second), meeting.time);
            if (of(meeting.second).spoilt <= meeting.time) spoil(of(meeting.first), meeting.time);
        }
    }
    Mask mask;
    for (History const& history : histories) {
        mask.kept.push_back(history.met && history.spoilt == never);
        mask.met += history.met;
    }
    return mask;
}

/// Distances between the places of the kept balls.
inline std::vector<double> distances(Eigen::Matrix3Xd const& places, Eigen::Matrix3Xd const& others,
                                     std::vector<bool> const& kept) {
    std::vector<double> all;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        auto const column = static_cast<Eigen::Index>(i);
        if (kept[i]) all.push_back((places.col(column) - others.col(column)).norm());
    }
    return all;
}

/// Places whose error falls as k^(-1/2), at k and 4k, taken to its limit by Richardson: what is
/// left is of second order.
inline Eigen::Matrix3Xd richardson(Eigen::Matrix3Xd const& at_k, Eigen::Matrix3Xd const& at_4k) {
    return 2 * at_4k - at_k;
}

/// The smallest value that a share of all does not exceed; NaN of none.
inline double quantile(std::vector<double> values, double const share) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    auto const rank =
        static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size())) - 1);
    auto const place = values.begin() + std::max<std::ptrdiff_t>(rank, 0);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

} // namespace clack::validation
