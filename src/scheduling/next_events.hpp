#pragma once
// The report's array of next collisions, and the total order that every queue keeps.

#include "prediction/earliest.hpp"
#include "state/huge_pages.hpp"
#include "state/real.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace clack {

/// What a ball meets next, as the report has it: another ball, or a wall as a negative integer.
using Partner = std::int32_t;
constexpr Partner wall_partner(std::int32_t wall) { return -1 - wall; } // 0..5 -> -1..-6
constexpr std::int32_t wall_of(Partner partner) { return -1 - partner; }
constexpr Partner nobody = no_ball;

/// A ball's next collision, and when the candidates it was found among expire.
template <class Real> struct NextEvent {
    Real contact = infinity<Real>;
    Real expiry = infinity<Real>;
    Partner partner = nobody;
    /// Whether its time stands in a queue for this ball, or else for its partner.
    bool filed = true;

    Real time() const { return contact < expiry ? contact : expiry; }
};

/// In the order in which simultaneous events are taken.
enum class EventKind : std::int8_t { expiry, ball, wall };

/// The next event of every ball. Of two balls that are going to touch, one at least has an entry
/// that is no later, so that it is predicted anew and tells the other. An entry may come to
/// nothing, when the partner has changed course since: an event between two balls is real only
/// while each names the other with the same time.
template <class Real> class NextEvents {
public:
    /// `numbers` are the permanent numbers of the balls, as they stand in memory at any time.
    explicit NextEvents(std::vector<std::int32_t> const& numbers)
        : events_(large_vector<NextEvent<Real>>(numbers.size())), numbers_(numbers) {}

    std::size_t size() const { return events_.size(); }
    NextEvent<Real>& operator[](std::int32_t ball) {
        return events_[static_cast<std::size_t>(ball)];
    }
    NextEvent<Real> const& operator[](std::int32_t ball) const {
        return events_[static_cast<std::size_t>(ball)];
    }

    std::int32_t number(std::int32_t ball) const {
        return numbers_[static_cast<std::size_t>(ball)];
    }

    EventKind kind(std::int32_t ball) const {
        NextEvent<Real> const& event = (*this)[ball];
        if (event.expiry <= event.contact) return EventKind::expiry;
        return event.partner < 0 ? EventKind::wall : EventKind::ball;
    }

    bool mutual(std::int32_t ball) const {
        NextEvent<Real> const& mine = (*this)[ball];
        NextEvent<Real> const& theirs = (*this)[mine.partner];
        return (theirs.partner == ball) & (theirs.contact == mine.contact);
    }

    /// The order of simultaneous events: kind, then permanent numbers.
    using Rank = std::tuple<EventKind, std::int32_t, std::int32_t>;
    Rank rank(std::int32_t ball) const { return rank(kind(ball), ball, (*this)[ball].partner); }

    /// The total order of events: time, then rank.
    bool precedes(std::int32_t a, std::int32_t b) const {
        Real const time_a = (*this)[a].time(), time_b = (*this)[b].time();
        return time_a != time_b ? time_a < time_b : rank(a) < rank(b);
    }

    /// Whether a contact of the two balls at `time` comes before what `ball` has.
    bool contact_precedes(Real time, std::int32_t ball, std::int32_t other) const {
        NextEvent<Real> const& own = (*this)[ball];
        if (time != own.contact) return time < own.contact;
        if (own.partner == nobody) return false;
        return rank(EventKind::ball, ball, other) <
               rank(own.partner < 0 ? EventKind::wall : EventKind::ball, ball, own.partner);
    }

    std::size_t bytes() const { return events_.capacity() * sizeof(NextEvent<Real>); }

private:
    Rank rank(EventKind kind, std::int32_t ball, Partner partner) const {
        std::int32_t const mine = number(ball);
        if (kind == EventKind::expiry) return {kind, mine, 0}; // whomever it will meet
        if (kind == EventKind::wall) return {kind, mine, wall_of(partner)};
        std::int32_t const theirs = number(partner);
        return {kind, std::min(mine, theirs), std::max(mine, theirs)};
    }

    std::vector<NextEvent<Real>> events_;
    std::vector<std::int32_t> const& numbers_;
};

} // namespace clack
