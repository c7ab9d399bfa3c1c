#pragma once
// What every ball will meet next, and when.

#include "neighbours/neighbour_search.hpp"
#include "prediction/earliest.hpp"
#include "resolution/elastic_balls.hpp"
#include "scheduling/agenda.hpp"
#include "state/ball_state.hpp"

#include <algorithm>
#include <utility>

namespace clack {

/// The state of a run and all that is foreseen of it: the agenda holds each ball's next event, as
/// the search's candidates and the model's rules give it. `Simulation` makes the events happen.
template <class Real, template <class> class Container, template <class, class> class Search,
          template <class> class Queue, template <class> class Model>
class Outlook {
protected:
    Outlook(BallState<Real, Container<Real>>&& state, Model<Real> model)
        : state_(std::move(state)), model_(std::move(model)), agenda_(state_.numbers),
          search_(model_.as_searched(state_.system), state_.cube),
          several_images_(touches_through_several_images(state_.system)) {
        if constexpr (requires { model_.expects_near = search_.candidates_are_near; })
            model_.expects_near = search_.candidates_are_near;
    }
    Outlook(Outlook const&) = delete; // the indexes refer to the state beside them
    Outlook& operator=(Outlook const&) = delete;

    static constexpr bool periodic = Container<Real>::boundary == Boundary::periodic;

    /// A ball that has a new course, or whose partner has.
    void predict(std::int32_t ball) {
        agenda_[ball] = next_event(ball);
        file(ball);
        tell_partner(ball);
    }

    /// Two balls that have collided. What they meet alone comes first: its roots wait for nothing
    /// that the contacts need, and are ready when those are.
    void predict_both(std::int32_t i, std::int32_t j) {
        auto const [alone_i, alone_j] = alone_both(i, j);
        auto const [found_i, found_j] = contacts_of_both(i, j);
        for (std::int32_t const ball : {found_i.ball, found_j.ball}) // they will be told
            prefetch(&agenda_[std::max(ball, 0)]);
        agenda_[i] = earlier_of(alone_i, found_i);
        file(i); // a queue hears of one change at a time
        agenda_[j] = earlier_of(alone_j, found_j);
        file(j);
        tell_partner(i);
        tell_partner(j);
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

    /// The report's second update: balls that were going to hit one of the two look again.
    void sweep(std::int32_t i, std::int32_t j) {
        for (std::int32_t ball = 0; ball < state_.count(); ++ball) {
            Partner const partner = agenda_[ball].partner;
            if ((partner == i || partner == j) && ball != i && ball != j && !agenda_.mutual(ball))
                predict(ball);
        }
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

    BallState<Real, Container<Real>> state_;
    Clock<Real>& clock_ = state_.clock;
    Model<Real> model_;
    Agenda<Real, Queue<Real>> agenda_;
    Search<Real, Container<Real>> search_;

private:
    auto scenery() const {
        return Scenery<Real, Container<Real>, Model<Real>>{state_.balls, state_.numbers,
                                                           state_.cube, model_, several_images_};
    }

    /// The next event of one ball from all its candidates and the walls.
    NextEvent<Real> next_event(std::int32_t ball) {
        NextEvent<Real> const event = alone(ball);
        return earlier_of(
            event, earliest_contact(scenery(), ball, search_.candidates(ball), clock_.offset));
    }

    /// What a ball meets without another: a wall, and the end of its candidates.
    NextEvent<Real> alone(std::int32_t ball) {
        return alone(ball, search_.expiry(state_.balls, ball, clock_.offset));
    }
    std::pair<NextEvent<Real>, NextEvent<Real>> alone_both(std::int32_t i, std::int32_t j) {
        if constexpr (requires { search_.expiries(state_.balls, i, j, clock_.offset); }) {
            auto const [of_i, of_j] = search_.expiries(state_.balls, i, j, clock_.offset);
            return {alone(i, of_i), alone(j, of_j)};
        } else {
            return {alone(i), alone(j)};
        }
    }
    NextEvent<Real> alone(std::int32_t ball, Real expiry) {
        NextEvent<Real> event;
        if constexpr (!periodic) {
            WallContact<Real> const wall = model_.wall_contact(state_[ball], state_.cube);
            event.contact = wall.time;
            event.partner = wall_partner(wall.wall);
        }
        event.expiry = model_.expiry(expiry);
        return event;
    }
    static NextEvent<Real> earlier_of(NextEvent<Real> event, Contact<Real> const& found) {
        if (!(event.contact < found.time)) {
            event.contact = found.time;
            event.partner = found.ball;
        }
        return event;
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

    bool several_images_;
};

} // namespace clack
