#include "scheduling/binary_heap.hpp"
#include "scheduling/calendar.hpp"
#include "scheduling/collision_table.hpp"
#include "tests/made_up_balls.hpp"

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

#include <numeric>

using namespace clack;

namespace {

/// The calendar of a large system.
struct LargeCalendar : Calendar<double> {
    explicit LargeCalendar(std::size_t count) : Calendar(count, Foresight::some) {}
};

using Queues =
    boost::mpl::list<CollisionTable<double>, BinaryHeap<double>, Calendar<double>, LargeCalendar,
                     BinaryHeap<float>, Calendar<float>, Calendar<long double>>;

template <class Queue> struct RealOf;
template <template <class> class Queue, class Real> struct RealOf<Queue<Real>> {
    using type = Real;
};
template <> struct RealOf<LargeCalendar> { using type = double; };

std::vector<std::int32_t> shuffled(std::int32_t count, std::mt19937_64& random) {
    std::vector<std::int32_t> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 0);
    for (std::size_t k = numbers.size(); k > 1; --k)
        std::swap(numbers[k - 1], numbers[random() % k]);
    return numbers;
}

/// A next event with a time at a wait of any size, or exactly `now`, or on a coarse lattice of
/// times that makes ties, or never.
template <class Real>
NextEvent<Real> any_event(std::int32_t ball, std::int32_t count, Real now,
                          std::mt19937_64& random) {
    NextEvent<Real> event;
    auto const wait = [&]() -> Real {
        switch (random() % 8) {
        case 0:
            return 0;
        case 1:
            return infinity<Real>;
        case 2:
            return static_cast<Real>(random() % 4) / 4 - std::fmod(now, Real(0.25)) + Real(0.25);
        default:
            return static_cast<Real>(std::pow(10.0, made_up::uniform(random, -4, 1)));
        }
    };
    event.contact = now + wait();
    event.expiry = now + wait();
    std::int32_t const other = static_cast<std::int32_t>(random() % static_cast<unsigned>(count));
    event.partner = other == ball ? wall_partner(static_cast<std::int32_t>(random() % 6)) : other;
    if (event.contact == infinity<Real>) event.partner = nobody;
    return event;
}

} // namespace

/// Whatever is asked in whatever order, the queue gives an event that none precedes.
BOOST_AUTO_TEST_CASE_TEMPLATE(earliest_is_first_in_the_total_order, Queue, Queues) {
    using Real = typename RealOf<Queue>::type;
    std::mt19937_64 random(3);
    for (std::int32_t const count : {1, 2, 7, 300}) {
        auto const numbers = shuffled(count, random);
        NextEvents<Real> next(numbers);
        for (std::int32_t k = 0; k < count; ++k) next[k] = any_event<Real>(k, count, 0, random);
        Queue queue(static_cast<std::size_t>(count));
        queue.rebuild(next, 0);
        Real now = 0;
        for (int step = 0; step < 3000; ++step) {
            std::int32_t const first = queue.earliest(next);
            std::int32_t best = 0;
            for (std::int32_t k = 1; k < count; ++k)
                if (next.precedes(k, best)) best = k;
            if (first == no_event) {
                BOOST_TEST_REQUIRE((next[best].time() == infinity<Real>));
            } else {
                BOOST_TEST_REQUIRE(!next.precedes(best, first));
                now = next[first].time();
            }
            // The event happens, and a few other balls change their plans.
            std::int32_t const changed = first == no_event ? 0 : first;
            next[changed] = any_event<Real>(changed, count, now, random);
            queue.update(next, changed);
            for (int k = 0; k < 3; ++k) {
                auto const ball =
                    static_cast<std::int32_t>(random() % static_cast<unsigned>(count));
                next[ball] = any_event<Real>(ball, count, now, random);
                queue.update(next, ball);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(order_is_time_then_kind_then_permanent_numbers) {
    std::vector<std::int32_t> const numbers{4, 3, 2, 1, 0};
    NextEvents<double> next(numbers);
    next[0] = {1, 9, 1};               // balls 4 and 3
    next[1] = {1, 9, 0};               // the same, from the other side
    next[2] = {1, 9, wall_partner(5)}; // ball 2 and a wall
    next[3] = {2, 1, wall_partner(0)}; // an expiry
    next[4] = {1, 9, 2};               // balls 0 and 2
    BOOST_TEST(next.precedes(3, 4));   // expiry before ball
    BOOST_TEST(next.precedes(4, 0));   // (0, 2) before (3, 4)
    BOOST_TEST(!next.precedes(0, 1));  // one event, named twice
    BOOST_TEST(!next.precedes(1, 0));
    BOOST_TEST(next.precedes(0, 2)); // ball before wall
    next[2].contact = 0.5;
    BOOST_TEST(next.precedes(2, 3)); // time before all
}

// What lies many revolutions of a calendar ahead comes in its turn, though nobody files it again.
BOOST_AUTO_TEST_CASE_TEMPLATE(an_event_far_ahead_is_not_forgotten, Queue, Queues) {
    using Real = typename RealOf<Queue>::type;
    constexpr std::int32_t count = 64;
    std::mt19937_64 random(5);
    auto const numbers = shuffled(count, random);
    NextEvents<Real> next(numbers);
    auto const soon = [&](Real now) {
        return now + static_cast<Real>(made_up::uniform(random, 0.5, 1.5));
    };
    for (std::int32_t ball = 0; ball < count; ++ball) next[ball].expiry = soon(0);
    for (std::int32_t const ball : {3, 17, 40}) next[ball].expiry = static_cast<Real>(ball);
    Queue queue(static_cast<std::size_t>(count));
    queue.rebuild(next, 0);
    std::vector<std::int32_t> late;
    for (Real now = 0; late.size() < 3;) {
        std::int32_t const first = queue.earliest(next);
        BOOST_TEST_REQUIRE(first != no_event);
        BOOST_TEST_REQUIRE(now <= next[first].time());
        now = next[first].time();
        BOOST_TEST_REQUIRE(now <= 40);
        if (now == static_cast<Real>(first)) late.push_back(first); // 3, 17 or 40
        next[first].expiry = soon(now);
        queue.update(next, first);
    }
    BOOST_TEST((late == std::vector<std::int32_t>{3, 17, 40}));
}
