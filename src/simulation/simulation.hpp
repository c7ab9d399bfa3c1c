#pragma once
// The event loop: from one event to the next, exactly.

#include "resolution/collision.hpp"
#include "simulation/engine.hpp"
#include "simulation/laws.hpp"
#include "simulation/look_ahead.hpp"
#include "simulation/outlook.hpp"

#include <algorithm>
#include <concepts>
#include <type_traits>
#include <utility>

namespace clack {

/// For runs that nobody watches: the calls are compiled out.
struct NoObserver {};

/// n equal hard balls in a cube. `Search` says which balls can meet, `Queue` which event is next:
/// indexes both, that leave no trace in the run. `Model` is what a collision is.
template <class Real, template <class> class Container, template <class, class> class Search,
          template <class> class Queue, template <class> class Model = ElasticBalls>
requires NeighbourSearch<Search<Real, Container<Real>>, Real> && EventQueue<Queue<Real>, Real>
class Simulation : private Outlook<Real, Container, Search, Queue, Model> {
    using Base = Outlook<Real, Container, Search, Queue, Model>;

public:
    using Number = Real;

    /// Goes on from the state of a run: a fresh start, or a checkpoint.
    explicit Simulation(BallState<Real, Container<Real>>&& state)
        : Simulation(std::move(state), Model<Real>(state.system)) {}
    Simulation(BallState<Real, Container<Real>>&& state, Model<Real> model)
        : Base(std::move(state), std::move(model)), laws_(state_.system, state_.clock.length) {
        rebuild();
    }

    /// The event loop. Events come in their total order; what an event is depends on the records
    /// alone, so any search and any queue go the same way to the last bit.
    template <class Observer> Stop advance(Goal const& goal, Observer&& observe) {
        Clock<Real> const until = moment<Real>(goal.time, clock_.length);
        for (std::uint64_t events = 0;; ++events) {
            if (tallies_.ball_collisions >= goal.ball_collisions) return Stop::collisions;
            if (events == goal.events) return Stop::events;
            std::int32_t const ball = agenda_.earliest();
            Real const time = ball == no_event ? infinity<Real> : agenda_[ball].time();
            if (clock_.epoch > until.epoch) return Stop::time;
            if (clock_.epoch == until.epoch && time > until.offset) {
                clock_.offset = later(clock_.offset, until.offset);
                return Stop::time;
            }
            if (!(time < static_cast<Real>(clock_.length))) {
                if (ball == no_event && goal.time == infinity<double>) return Stop::never;
                begin_epoch();
                continue;
            }
            if constexpr (can_look_ahead) {
                if (agenda_.queue().looks_ahead())
                    LookAhead::look(state_, agenda_, search_, agenda_.queue());
            }
            laws_.time_goes_on(clock_, time);
            clock_.offset = time;
            take(ball, observe);
        }
    }

    /// Makes the present moment time 0 and forgets what was counted.
    void start_clock() {
        state_.set_records_to(clock_.offset);
        clock_.epoch = 0;
        tallies_ = {};
        rebuild();
    }

    BallState<Real, Container<Real>> const& state() const { return state_; }

    std::size_t bytes() const { return state_.bytes() + agenda_.bytes() + search_.bytes(); }

private:
    using Base::agenda_, Base::clock_, Base::model_, Base::search_, Base::state_, Base::periodic;
    using Base::predict, Base::predict_both, Base::rebuild, Base::refresh, Base::sweep;

    static constexpr bool can_look_ahead =
        LookAhead::possible<Search<Real, Container<Real>>, Queue<Real>>;

    // --- one event

    template <class Observer> void take(std::int32_t ball, Observer& observe) {
        switch (agenda_.kind(ball)) {
        case EventKind::expiry:
            refresh(ball);
            if constexpr (requires { search_.wants_rebuild(); })
                if (search_.wants_rebuild()) rebuild();
            break;
        case EventKind::wall:
            bounce(ball, wall_of(agenda_[ball].partner), observe);
            break;
        case EventKind::ball:
            // A partner that has changed course since does not agree: look again.
            agenda_.mutual(ball) ? collide(ball, agenda_[ball].partner, observe) : predict(ball);
        }
    }

    template <class Observer> void collide(std::int32_t i, std::int32_t j, Observer& observe) {
        // Which is called i makes no difference but to who is told.
        if constexpr (!std::is_same_v<Observer, NoObserver>) {
            if (agenda_.number(j) < agenda_.number(i)) std::swap(i, j);
        }
        state_.fly_to(i, clock_.offset);
        state_.fly_to(j, clock_.offset);
        Pair<Real> const pair = pair_now(state_[i], state_[j], state_.cube);
        Vector3<Real> const separation{pair.x, pair.y, pair.z};
        Real const distance2 = dot<Real>(separation, separation);
        Real const diameter2 = model_.diameter_squared(pair, clock_.offset);
        if (!laws_.near_contact(distance2, diameter2)) {
            auto const [lower, higher] = std::minmax({agenda_.number(i), agenda_.number(j)});
            laws_.in_contact(distance2, diameter2, pair, clock_, lower, higher, tallies_);
        }

        Vector3<Real> const impulse =
            static_cast<Real>(state_.system.mass) * exchange_impulse(i, j, separation);
        ++tallies_.ball_collisions;
        tallies_.virial += static_cast<double>(dot<Real>(separation, impulse));
        double const overlap = static_cast<double>((diameter2 - distance2) / (2 * diameter2));
        if (overlap > tallies_.deepest_overlap) tallies_.deepest_overlap = overlap;
        if constexpr (!std::is_same_v<Observer, NoObserver>) {
            observe(collision(CollisionKind::ball, i, agenda_.number(j), state_[j].velocity,
                              separation, impulse));
        }
        search_.settle(state_.balls, i);
        search_.settle(state_.balls, j);
        predict_both(i, j);
        if constexpr (Queue<Real>::staleness == Staleness::swept) sweep(i, j);
    }

    /// Returns the momentum per unit mass that j is given. Both will be predicted anew, so that
    /// neither waits for the other.
    [[gnu::always_inline]] Vector3<Real> exchange_impulse(std::int32_t i, std::int32_t j,
                                                          Vector3<Real> const& separation) {
        Ball<Real>& one = state_[i];
        Ball<Real>& other = state_[j];
        if constexpr (heeds_notes<Model<Real>>) {
            Vector3<Real> velocity_i = one.velocity, velocity_j = other.velocity;
            Vector3<Real> given =
                model_.collide(velocity_i, velocity_j, separation, tallies_.ball_collisions);
            set_velocity_and_note(one, velocity_i, infinity<Real>);
            set_velocity_and_note(other, velocity_j, infinity<Real>);
            return given;
        } else {
            return model_.collide(one.velocity, other.velocity, separation,
                                  tallies_.ball_collisions);
        }
    }

    template <class Observer> void bounce(std::int32_t ball, std::int32_t wall, Observer& observe) {
        state_.fly_to(ball, clock_.offset);
        if constexpr (!periodic) {
            int const d = wall / 2;
            int const towards = wall % 2 == 0 ? -1 : 1;
            Real const before = state_[ball].velocity[d];
            Real const after = model_.reflect(before, towards);
            state_[ball].point[d] = model_.plane(state_.cube, towards, clock_.offset, before);
            state_[ball].velocity[d] = after;
            Vector3<Real> impulse = Vector3<Real>::Zero();
            impulse[d] = static_cast<Real>(state_.system.mass) * (before - after);
            ++tallies_.wall_collisions;
            tallies_.wall_impulse += towards * static_cast<double>(impulse[d]);
            if constexpr (!std::is_same_v<Observer, NoObserver>) {
                observe(collision(CollisionKind::wall, ball, wall, Vector3<Real>::Zero(),
                                  Vector3<Real>::Zero(), impulse));
            }
        }
        predict(ball);
        if constexpr (Queue<Real>::staleness == Staleness::swept) sweep(ball, ball);
    }

    // --- indexes

    void begin_epoch() {
        auto const length = static_cast<Real>(clock_.length);
        state_.set_records_to(length);
        ++clock_.epoch;
        model_.begin_epoch(length);
        if constexpr (Model<Real>::keeps_energy)
            laws_.energy_is_kept(state_.kinetic_energy(), clock_, tallies_);
        rebuild();
    }

    Collision<Real> collision(CollisionKind kind, std::int32_t first, std::int64_t second,
                              Vector3<Real> const& velocity_second, Vector3<Real> const& separation,
                              Vector3<Real> const& impulse) {
        return {kind,
                clock_.epoch,
                clock_.offset,
                clock_.time(),
                agenda_.number(first),
                second,
                state_[first].velocity,
                velocity_second,
                state_[first].point,
                separation,
                impulse};
    }

    Tallies& tallies_ = state_.tallies;
    Laws<Real> laws_;
};

} // namespace clack
