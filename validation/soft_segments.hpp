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

/// Finds out which balls soft ones cannot follow.
class Masking {
public:
    Masking(Segment const& segment, double span)
        : segment_(segment), span_(span),
          histories_(static_cast<std::size_t>(segment.start.positions.cols())) {}

    Mask mask() {
        // A collision that follows at once spoils the one before it too, and so the partner that it
        // had: the list is gone through until nothing changes.
        do go_through();
        while (changed_);
        Mask mask;
        for (History const& history : histories_) {
            mask.kept.push_back(history.met && history.spoilt == never);
            mask.met += history.met;
        }
        return mask;
    }

private:
    static constexpr double never = std::numeric_limits<double>::infinity();

    struct History {
        double last_ball = -never, last_wall = -never;
        double spoilt = never; // since then
        bool met = false;
    };

    History& of(std::int64_t ball) { return histories_[static_cast<std::size_t>(ball)]; }

    void spoil(History& history, double since) {
        if (!(since < history.spoilt)) return;
        history.spoilt = since;
        changed_ = true;
    }

    void look(History& history, Meeting const& meeting) {
        bool const wall = meeting.kind == CollisionKind::wall;
        double const before =
            wall ? history.last_ball : std::max(history.last_ball, history.last_wall);
        if (meeting.time - before < span_) spoil(history, before);
        if (segment_.time - meeting.time < span_) spoil(history, meeting.time);
        (wall ? history.last_wall : history.last_ball) = meeting.time;
        history.met = true;
    }

    void go_through() {
        changed_ = false;
        for (History& history : histories_) history.last_ball = history.last_wall = -never;
        for (Meeting const& meeting : segment_.meetings) {
            History& first = of(meeting.first);
            look(first, meeting);
            if (meeting.kind == CollisionKind::wall) continue;
            History& second = of(meeting.second);
            look(second, meeting);
            if (first.spoilt <= meeting.time) spoil(second, meeting.time);
            if (second.spoilt <= meeting.time) spoil(first, meeting.time);
        }
    }

    Segment const& segment_;
    double span_;
    std::vector<History> histories_;
    bool changed_ = false;
};

/// Keeps the balls that collide, and of these drops where soft balls have no limit or none yet: a
/// ball one of whose collisions lies within `span` of the segment's end, or of another of its own
/// (two walls do not mind each other: their springs push along different axes), and from then on
/// every ball that meets such a one.
inline Mask masked(Segment const& segment, double const span) {
    return Masking(segment, span).mask();
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
