// Whoever is filed, no event is missed.

#include "scheduling/agenda.hpp"
#include "scheduling/binary_heap.hpp"
#include "scheduling/calendar.hpp"
#include "tests/made_up_balls.hpp"

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

#include <numeric>

using namespace clack;

namespace {

/// Balls that meet whom chance will have, at times on a lattice now and then, for ties. They keep
/// the rules of the event loop: a contact is told to the partner, one that both name happens, any
/// other is looked for again, and what expires is renewed.
template <class Queue> struct Chance {
    static constexpr std::int32_t count = 60;
    std::mt19937_64 random{11};
    std::vector<std::int32_t> numbers = std::vector<std::int32_t>(count);
    Agenda<double, Queue> agenda =
        (std::iota(numbers.begin(), numbers.end(), 0), Agenda<double, Queue>(numbers));
    double now = 0;
    int met = 0, expired = 0, missed = 0;

    Chance() {
        for (std::int32_t ball = 0; ball < count; ++ball) agenda[ball] = any(ball);
        agenda.rebuild(0);
    }

    double wait() {
        double const any_time = std::pow(10.0, made_up::uniform(random, -3, 1));
        return random() % 8 == 0 ? std::floor(now + 1) + 1 - now : any_time;
    }
    std::int32_t other_than(std::int32_t ball) {
        return (ball + 1 + static_cast<std::int32_t>(random() % (count - 1))) % count;
    }
    NextEvent<double> any(std::int32_t ball) {
        if (random() % 4 == 0) return {infinity<double>, now + wait(), nobody};
        return {now + wait(), now + wait(), other_than(ball)};
    }
    void predict(std::int32_t ball) {
        agenda[ball] = any(ball);
        agenda.file(ball);
        agenda.tell_partner(ball);
    }

    void take(std::int32_t ball) {
        std::int32_t const partner = agenda[ball].partner;
        switch (agenda.kind(ball)) {
        case EventKind::expiry:
            ++expired;
            return renew(ball);
        case EventKind::wall:
            return predict(ball);
        case EventKind::ball:
            if (!agenda.mutual(ball)) return ++missed, predict(ball);
            ++met;
            agenda[ball] = any(ball);
            agenda.file(ball);
            agenda[partner] = any(partner);
            agenda.file(partner);
            agenda.tell_partner(ball);
            agenda.tell_partner(partner);
        }
    }
    void renew(std::int32_t ball) {
        agenda[ball].expiry = now + wait();
        auto const found = any(ball);
        if (found.partner < 0 || !agenda.contact_precedes(found.contact, ball, found.partner))
            return agenda.file_expiry(ball);
        agenda.set_contact(ball, found.contact, found.partner);
        agenda.file(ball);
        agenda.tell_partner(ball);
    }

    std::int32_t first_of_all() const {
        std::int32_t first = 0;
        for (std::int32_t ball = 1; ball < count; ++ball)
            if (agenda.precedes(ball, first)) first = ball;
        return first;
    }
};

using Queues = boost::mpl::list<BinaryHeap<double>, Calendar<double>>;

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(no_event_of_any_ball_is_missed, Queue, Queues) {
    Chance<Queue> chance;
    for (int step = 0; step < 40'000; ++step) {
        std::int32_t const first = chance.first_of_all();
        std::int32_t const ball = chance.agenda.earliest();
        BOOST_TEST_REQUIRE(ball != no_event);
        BOOST_TEST_REQUIRE(!chance.agenda.precedes(first, ball));
        chance.now = chance.agenda[ball].time();
        chance.take(ball);
    }
    BOOST_TEST(chance.met > 4'000);
    BOOST_TEST(chance.expired > 4'000);
    BOOST_TEST(chance.missed > 400);
}

// More events of one moment than stand in a row: an expiry holds, whomever a ball is told to meet
BOOST_AUTO_TEST_CASE(an_expiry_holds_whatever_the_ball_is_told) {
    constexpr std::int32_t count = 200;
    std::vector<std::int32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    Agenda<double, Calendar<double>> agenda(numbers);
    for (std::int32_t ball = 0; ball < count; ++ball) agenda[ball] = {infinity<double>, 1, nobody};
    agenda.rebuild(0);
    for (std::int32_t ball = 0; ball < count; ++ball) {
        BOOST_TEST_REQUIRE(agenda.earliest() == ball);
        agenda[ball] = {2, 5, (ball + 1) % count}; // to be met by the next, which expires at 1
        agenda.file(ball);
        agenda.tell_partner(ball);
    }
}

// Half of the entries is what it is for.
BOOST_AUTO_TEST_CASE(an_event_of_two_balls_is_filed_for_one) {
    std::vector<std::int32_t> const numbers{0, 1, 2};
    Agenda<double, Calendar<double>> agenda(numbers);
    agenda[0] = {1, 9, 1};
    agenda[1] = {2, 9, 2};
    agenda[2] = {2, 9, 1};
    agenda.rebuild(0);
    agenda[2].filed = false; // ball 1 stands for both
    BOOST_TEST(agenda.tell_partner(0));
    BOOST_TEST(agenda[0].filed);
    BOOST_TEST(!agenda[1].filed); // ball 0 stands for both
    BOOST_TEST(agenda[2].filed);  // alone again
    agenda.file_expiry(1);
    BOOST_TEST(!agenda[1].filed);
    agenda[1].expiry = 0.5;
    agenda.file_expiry(1);
    BOOST_TEST(agenda[1].filed);
}
