#pragma once
// The event loop: from one event to the next, exactly.

#include "neighbours/neighbour_search.hpp"
#include "prediction/earliest.hpp"
#include "resolution/collision.hpp"
#include "resolution/elastic_balls.hpp"
#include "scheduling/agenda.hpp"
#include "simulation/engine.hpp"
#include "simulation/laws.hpp"
#include "simulation/look_ahead.hpp"
#include "simulation/scout.hpp"
#include "state/ball_state.hpp"

#include <algorithm>
#include <concepts>
#include <memory>
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
class Simulation {
public:
    using Number = Real;

    /// Goes on from the state of a run: a fresh start, or a checkpoint.
    explicit Simulation(BallState<Real, Container<Real>>&& state)
        : Simulation(std::move(state), Model<Real>(state.system)) {}
    Simulation(BallState<Real, Container<Real>>&& state, Model<Real> model)
        : state_(std::move(state)), model_(std::move(model)), agenda_(state_.numbers),
          search_(model_.as_searched(state_.system), state_.cube),
          laws_(state_.system, state_.clock.length),
          several_images_(touches_through_several_images(state_.system)) {
        rebuild();
    }
    Simulation(Simulation const&) = delete; // the indexes refer to the state beside them
    Simulation& operator=(Simulation const&) = delete;

    /// The event loop. Events come in their total order; what an event is depends on the records
    /// alone, so any search and any queue go the same way to the last bit.
    template <class Observer> Stop advance(Goal const& goal, Observer&& observe) {
        typename Lookout::Watch const watch(scout_.get());
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
                alone([&] { begin_epoch(); });
                continue;
            }
            if constexpr (can_look_ahead) {
                if (agenda_.queue().looks_ahead())
                    LookAhead::look(state_, agenda_, search_, agenda_.queue());
            }
            if (scout_) scout_->event_comes();
            laws_.time_goes_on(clock_, time);
            clock_.offset = time;
            take(ball, observe);
        }
    }

    /// From now on a second thread reads ahead, where that is possible.
    void read_ahead() {
        if constexpr (Lookout::possible) {
            if (!scout_)
                scout_ = std::make_unique<Lookout>(state_, agenda_, search_, agenda_.queue());
        }
    }
    int threads() const { return scout_ ? 2 : 1; }

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
    static constexpr bool periodic = Container<Real>::boundary == Boundary::periodic;
    static constexpr bool can_look_ahead =
        LookAhead::possible<Search<Real, Container<Real>>, Queue<Real>>;

    using Lookout =
        Scout<BallState<Real, Container<Real>>, Real, Search<Real, Container<Real>>, Queue<Real>>;

    auto scenery() const {
        return Scenery<Real, Container<Real>, Model<Real>>{state_.balls, state_.numbers,
                                                           state_.cube, model_, several_images_};
    }

    // --- one event

    template <class Observer> void take(std::int32_t ball, Observer& observe) {
        switch (agenda_.kind(ball)) {
        case EventKind::expiry:
            refresh(ball);
            if constexpr (requires { search_.wants_rebuild(); })
                if (search_.wants_rebuild()) alone([&] { rebuild(); });
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
        Pair<Real> const pair = pair_of(state_[i], state_[j], state_.cube, clock_.offset);
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
    Vector3<Real> exchange_impulse(std::int32_t i, std::int32_t j,
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

    /// The search's own event: new candidates for a ball that flies on. The collision that it has
    /// found stays unless one of them comes first.
    void refresh(std::int32_t ball) {
        auto const fresh = search_.refresh(state_.balls, ball, clock_.offset);
        Contact<Real> const found =
            earliest_contact(scenery(), ball, fresh, clock_.offset, agenda_[ball].contact);
        agenda_[ball].expiry = model_.expiry(search_.expiry(state_.balls, ball, clock_.offset));
        bool const first =
            found.ball != no_ball && agenda_.contact_precedes(found.time, ball, found.ball);
        // Only news is told: the partner may have changed course since the old contact was found.
        if (!first) return agenda_.file_expiry(ball);
        agenda_.set_contact(ball, found.time, found.ball);
        file(ball);
        tell_partner(ball);
    }

    // --- prediction

    /// The next event of one ball from all its candidates and the walls.
    NextEvent<Real> next_event(std::int32_t ball) {
        return next_event(
            ball, earliest_contact(scenery(), ball, search_.candidates(ball), clock_.offset));
    }
    NextEvent<Real> next_event(std::int32_t ball, Contact<Real> const& found) {
        NextEvent<Real> event{found.time, infinity<Real>, found.ball};
        if constexpr (!periodic) {
            WallContact<Real> const wall = model_.wall_contact(state_[ball], state_.cube);
            if (wall.time < event.contact) {
                event.contact = wall.time;
                event.partner = wall_partner(wall.wall);
            }
        }
        event.expiry = model_.expiry(search_.expiry(state_.balls, ball, clock_.offset));
        return event;
    }

    void predict(std::int32_t ball) {
        agenda_[ball] = next_event(ball);
        file(ball);
        tell_partner(ball);
    }

    /// Two balls that have collided.
    void predict_both(std::int32_t i, std::int32_t j) {
        auto const [found_i, found_j] = contacts_of_both(i, j);
        for (std::int32_t const ball : {found_i.ball, found_j.ball}) // they will be told
            prefetch(&agenda_[std::max(ball, 0)]);
        agenda_[i] = next_event(i, found_i);
        file(i); // a queue hears of one change at a time
        agenda_[j] = next_event(j, found_j);
        file(j);
        tell_partner(i);
        tell_partner(j);
    }

    std::pair<Contact<Real>, Contact<Real>> contacts_of_both(std::int32_t i, std::int32_t j) {
        if constexpr (requires { search_.candidates_of_both(i, j); }) {
            auto const [around_i, around_j] = search_.candidates_of_both(i, j);
            return earliest_contacts(scenery(), i, around_i, j, around_j, clock_.offset);
        } else {
            auto const of = [&](std::int32_t ball) {
                return earliest_contact(scenery(), ball, search_.candidates(ball), clock_.offset);
            };
            return {of(i), of(j)};
        }
    }

    /// Tells the queue, and the predictions of other balls, of a ball's next event.
    void file(std::int32_t ball) {
        note(ball, agenda_[ball].contact);
        agenda_.file(ball);
    }
    void tell_partner(std::int32_t ball) {
        if (agenda_.tell_partner(ball)) note(agenda_[ball].partner, agenda_[ball].contact);
    }

    /// For the predictions of other balls: when this one will touch something, as far as is known.
    void note(std::int32_t ball, Real contact) {
        if constexpr (heeds_notes<Model<Real>>) state_[ball].note = contact;
    }

    /// The report's second update: balls that were going to hit one of the two look again.
    void sweep(std::int32_t i, std::int32_t j) {
        for (std::int32_t ball = 0; ball < state_.count(); ++ball) {
            Partner const partner = agenda_[ball].partner;
            if ((partner == i || partner == j) && ball != i && ball != j && !agenda_.mutual(ball))
                predict(ball);
        }
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

    /// At any moment: what comes does not depend on it.
    void rebuild() {
        state_.put_in_memory_order();
        search_.rebuild(state_.balls, clock_.offset);
        for (std::int32_t ball = 0; ball < state_.count(); ++ball) note(ball, infinity<Real>);
        for (std::int32_t ball = 0; ball < state_.count(); ++ball) {
            agenda_[ball] = next_event(ball);
            note(ball, agenda_[ball].contact);
        }
        agenda_.rebuild(clock_.offset);
    }

    /// While nobody looks on.
    template <class Task> void alone(Task&& task) {
        if (scout_) scout_->halt();
        task();
        if (scout_) scout_->go();
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

    BallState<Real, Container<Real>> state_;
    Clock<Real>& clock_ = state_.clock;
    Tallies& tallies_ = state_.tallies;
    Model<Real> model_;
    Agenda<Real, Queue<Real>> agenda_;
    Search<Real, Container<Real>> search_;
    Laws<Real> laws_;
    bool several_images_;
    std::unique_ptr<Lookout> scout_; // the last one: it reads the others
};

} // namespace clack
