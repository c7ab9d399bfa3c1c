#pragma once
// Those who watch a run: what each observable costs a scene that does not ask for it.

#include "observables/bond_order.hpp"
#include "observables/density_profile.hpp"
#include "observables/event_replay.hpp"
#include "observables/free_flights.hpp"
#include "observables/helfand_moments.hpp"
#include "observables/radial_distribution.hpp"
#include "observables/self_correlation.hpp"
#include "observables/structure_factor.hpp"
#include "observables/tangent_vector.hpp"
#include "validation/timing.hpp"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace clack::validation::price {

/// Keeps the events that were last.
class EventKeeper final : public CollisionObserver {
public:
    void operator()(Collision<double> const& collision) override {
        kept_[next_++ % kept_.size()] = collision;
    }

private:
    std::vector<Collision<double>> kept_ = std::vector<Collision<double>>(4096);
    std::size_t next_ = 0;
};

inline Snapshot at_start(Start const& start) {
    Snapshot snapshot;
    snapshot.positions = start.positions;
    snapshot.velocities = start.velocities;
    return snapshot;
}

/// Holds each event against the laws.
class EventChecker final : public CollisionObserver {
public:
    EventChecker(System const& system, Start const& start, double const epoch)
        : replay_(system, epoch, unit_roundoff<double>, at_start(start)) {}
    void operator()(Collision<double> const& collision) override { replay_.add_event(collision); }

private:
    EventReplay replay_;
};

// --- what eats collisions

inline TimedRun with_flights(std::unique_ptr<Engine> engine) {
    auto flights = std::make_unique<FreeFlights>(engine->system().count);
    FreeFlights& watched = *flights; // lives in the run, beside who empties it
    TimedRun run{std::move(engine), std::move(flights)};
    run.look = [&watched](Engine const&) { watched.forget(); };
    return run;
}
inline TimedRun with_moments(std::unique_ptr<Engine> engine) {
    auto moments = std::make_unique<HelfandMoments>(engine->system(), engine->snapshot());
    return {std::move(engine), std::move(moments)};
}
inline TimedRun with_tangent(std::unique_ptr<Engine> engine) {
    Eigen::Matrix3Xd const ones = Eigen::Matrix3Xd::Ones(3, engine->system().count);
    auto vector = std::make_unique<TangentVector>(engine->system(), ones, ones);
    TangentVector& watched = *vector;
    TimedRun run{std::move(engine), std::move(vector)};
    run.look = [&watched](Engine const& at) { // or it would outgrow a double
        watched.move_to(at.time());
        watched.normalise();
    };
    return run;
}

// --- what eats snapshots, one for each collision of a ball

/// A run that hands its snapshots to an observable.
template <class Observable>
TimedRun with_looks(std::unique_ptr<Engine> engine, Observable observable) {
    TimedRun run{std::move(engine)};
    run.look = [observable = std::move(observable)](Engine const& at) mutable {
        observable.add(at.snapshot());
    };
    return run;
}

/// As if space repeated itself: observables that need it cost the same.
inline System as_if_periodic(System system) {
    system.boundary = Boundary::periodic;
    return system;
}

inline TimedRun with_profile(std::unique_ptr<Engine> engine) {
    DensityProfile profile(engine->system(), engine->system().side / 2, 50);
    return with_looks(std::move(engine), std::move(profile));
}
inline TimedRun with_correlation(std::unique_ptr<Engine> engine) {
    constexpr std::size_t longest = 10; // lags, and as many origins of time
    return with_looks(std::move(engine), SelfCorrelation(0, longest, 1));
}
inline TimedRun with_pairs(std::unique_ptr<Engine> engine) {
    System const system = as_if_periodic(engine->system());
    constexpr double reach = 2; // [diameters]
    return with_looks(std::move(engine), RadialDistribution(system, reach * system.diameter, 50));
}
inline TimedRun with_waves(std::unique_ptr<Engine> engine) {
    System const system = as_if_periodic(engine->system());
    return with_looks(std::move(engine), StructureFactor(system, 9));
}

/// The bonds of a snapshot at a time.
struct BondOrder {
    System system;
    double sum = 0;

    void add(Snapshot const& snapshot) {
        constexpr double reach = 1.5; // [diameters]
        sum += bond_order(system, snapshot, reach * system.diameter);
    }
};
inline TimedRun with_bonds(std::unique_ptr<Engine> engine) {
    System const system = as_if_periodic(engine->system());
    return with_looks(std::move(engine), BondOrder{system});
}

} // namespace clack::validation::price
