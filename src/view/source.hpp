#pragma once
// Where the balls come from: the engine at work, or a file. One thread at a time.

#include "observables/pressure.hpp"
#include "state/snapshot.hpp"
#include "state/system.hpp"
#include "view/history.hpp"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace clack::view {

/// Of so many balls all that a picture needs is done in a few milliseconds; of more, what may wait
/// is done later or on another thread, so that the window answers.
constexpr std::int64_t few_balls = 3000;

/// A collision that will happen. `second` is -1 for a wall.
struct NextCollision {
    double time;
    std::int64_t first, second;
};

enum class Progress { arrived, under_way };

class Source {
public:
    virtual ~Source() = default;

    virtual System const& system() const = 0;
    virtual double time() const = 0;
    /// What can be shown: to infinity while the engine runs.
    virtual double first_time() const = 0;
    virtual double last_time() const = 0;

    /// Moves towards a later time for a hundredth of a second or so.
    virtual Progress advance(double until) = 0;
    /// To an earlier time or a later one, however long it takes.
    virtual void seek(double to) = 0;
    /// To the moment of the next collision, or of the latest one that is past; exactly. False where
    /// there is none.
    virtual bool step() = 0;
    virtual bool step_back() = 0;

    /// Exact places at the present time.
    virtual Snapshot snapshot() const = 0;
    /// What has been counted until now.
    virtual Sample sample() const = 0;
    /// None where there is none; of no balls where collisions are not known, in a file without
    /// them.
    virtual History const* history() const = 0;
    virtual void trace(std::int64_t ball) = 0;

    /// Finds the next collision of all balls, or of one of them; exact, as of now. None where it is
    /// not known.
    using Search = std::function<std::optional<NextCollision>()>;
    /// A search that takes long may be done on any thread, and while the source goes on.
    virtual Search search(std::optional<std::int64_t> ball) = 0;

    /// Sides of the start, for colours: where each ball was at first_time.
    virtual Eigen::Matrix3Xd const& start_places() const = 0;
    /// "the engine: cell grid, calendar, double", "gas.h5, frame 3 of 20".
    virtual std::string description() const = 0;
    /// What is to be known of times between those that the source knows; empty where all is exact.
    virtual std::string remark() const { return {}; }
    /// Share of what comes before the first time that is done: an equilibration.
    virtual double preparation_share() const { return 1; }
    /// Whether a file is still being written; looks whether there is more to show than before.
    virtual bool may_grow() const { return false; }
    virtual void refresh() {}
};

} // namespace clack::view
