#pragma once
// The engine as files, observables and the command line see it: any container, precision, search
// and queue behind one interface of a few coarse calls.

#include "resolution/collision.hpp"
#include "state/checkpoint.hpp"
#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>

namespace clack {

enum class Method { automatic, table, heap, fast };
enum class Precision { single_, double_, extended, quadruple };

/// Where `Engine::advance` stops: at whichever comes first. A time is reached exactly, a count at
/// the instant of the collision that fills it.
struct Goal {
    double time = std::numeric_limits<double>::infinity();
    std::uint64_t ball_collisions = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t events = std::numeric_limits<std::uint64_t>::max(); // of any kind, in this call
};

enum class Stop {
    time,       // the goal's time is reached
    collisions, // the goal's number of ball-ball collisions is reached
    events,     // the goal's number of events is used up: call again to go on
    never       // no event will ever happen, and the goal has no time
};

/// Eats collisions one by one, in the order in which they happen.
class CollisionObserver {
public:
    virtual ~CollisionObserver() = default;
    virtual void operator()(Collision<double> const& collision) = 0;
};

/// What runs behind the interface, in words, for `clack info` and provenance.
struct ModelDescription {
    std::string boundary, search, queue, precision, reason;
};

/// Equal hard balls in a cube, moved exactly from collision to collision.
/// Every call leaves the engine between two events. Throws LawBroken when a law of nature is
/// broken (overlap beyond rounding, jammed balls, energy lost).
class Engine {
public:
    virtual ~Engine() = default;

    /// Moves on until the goal; with an observer, tells it each collision.
    virtual Stop advance(Goal const& goal, CollisionObserver* observer = nullptr) = 0;

    /// Makes the present instant time 0 and forgets what was counted so far.
    virtual void start_clock() = 0;
    /// From now on each collision enters `hash()`.
    virtual void hash_collisions() = 0;

    virtual double time() const = 0; // since time 0, rounded to double
    virtual Tallies const& tallies() const = 0;
    virtual std::uint64_t hash() const = 0; // 0 unless asked for
    virtual double kinetic_energy() const = 0;
    virtual Eigen::Vector3d momentum() const = 0;
    virtual Snapshot snapshot() const = 0; // exact positions at the present time
    virtual Checkpoint checkpoint() const = 0;
    virtual System const& system() const = 0;
    virtual ModelDescription model() const = 0;
    virtual std::size_t bytes() const = 0; // of memory that the engine holds
};

/// The engine for a system: `automatic` picks the method by count and packing fraction.
/// The start must be free of overlaps and inside the container: the scene layer checks that.
std::unique_ptr<Engine> make_engine(System const& system, Method method, Precision precision,
                                    Start const& start);

/// Goes on from a checkpoint of the same system and precision; any method continues to the same
/// bits.
std::unique_ptr<Engine> make_engine(System const& system, Method method, Precision precision,
                                    Checkpoint const& checkpoint);

/// Bytes that `make_engine` and the run will take, known before anything is allocated.
std::size_t expected_bytes(System const& system, Method method, Precision precision);

} // namespace clack
