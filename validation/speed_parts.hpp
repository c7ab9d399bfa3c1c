#pragma once
// Where the time of a collision goes: the engine once more, with a search and a queue that say when
// they are at work, looked at ten thousand times a second. A ball's run costs two stores a call
// more, the engine that everybody else uses nothing.

#include "neighbours/cell_grid.hpp"
#include "neighbours/every_pair.hpp"
#include "neighbours/neighbour_list.hpp"
#include "scheduling/binary_heap.hpp"
#include "scheduling/calendar.hpp"
#include "scheduling/collision_table.hpp"
#include "simulation/build_engine.hpp"
#include "validation/timing.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <numeric>
#include <stdexcept>
#include <utility>

#if defined(__x86_64__)
#include <x86intrin.h>
#endif

namespace clack::validation::speed {

/// What a run is at. A change of epoch, which predicts everything afresh, is spread over the parts
/// that it uses.
enum class Part {
    search,     // gathering candidates, keeping cells and lists up to date
    prediction, // from the candidates to the earliest contact
    queue,      // filing events, finding the next one
    collision,  // from an event's turn to the first candidates: flight, impulse, laws
    rest        // next events, telling partners; the table's sweep
};
constexpr std::size_t part_count = 5;
constexpr std::array<char const*, part_count> part_names{"search", "prediction", "queue",
                                                         "collision", "rest"};
using Shares = std::array<double, part_count>; // of the time; their sum is 1

/// The part that is under way. A signal's handler reads it.
inline std::atomic<Part> part_under_way{Part::rest};
static_assert(std::atomic<Part>::is_always_lock_free);

inline void begin_part(Part const part) {
    std::atomic_signal_fence(std::memory_order_seq_cst); // the compiler keeps the order
    part_under_way.store(part, std::memory_order_relaxed);
    std::atomic_signal_fence(std::memory_order_seq_cst);
}

/// As long as a call lasts, one part; afterwards another.
class During {
public:
    During(Part const now, Part const afterwards) : afterwards_(afterwards) { begin_part(now); }
    During(During const&) = delete;
    During& operator=(During const&) = delete;
    ~During() { begin_part(afterwards_); }

private:
    Part afterwards_;
};

/// A search that says when it is at work. What it does not name here passes through.
template <class Search> class WatchedSearch : public Search {
public:
    using Search::Search;

    template <class... Given> decltype(auto) candidates(Given&&... given) {
        During const during(Part::search, Part::prediction);
        return Search::candidates(std::forward<Given>(given)...);
    }
    /// Asked for by who looks ahead: nothing is predicted afterwards.
    template <class... Given> decltype(auto) candidates(Given&&... given) const {
        return Search::candidates(std::forward<Given>(given)...);
    }
    template <class... Given>
    auto candidates_of_both(Given&&... given) requires requires(Search search) {
        search.candidates_of_both(given...);
    }
    {
        During const during(Part::search, Part::prediction);
        return Search::candidates_of_both(std::forward<Given>(given)...);
    }
    template <class... Given> decltype(auto) refresh(Given&&... given) {
        During const during(Part::search, Part::prediction);
        return Search::refresh(std::forward<Given>(given)...);
    }
    template <class... Given> decltype(auto) expiry(Given&&... given) {
        During const during(Part::search, Part::rest);
        return Search::expiry(std::forward<Given>(given)...);
    }
    template <class... Given> decltype(auto) rebuild(Given&&... given) {
        During const during(Part::search, Part::rest);
        return Search::rebuild(std::forward<Given>(given)...);
    }
};

/// A queue that does.
template <class Queue> class WatchedQueue : public Queue {
public:
    using Queue::Queue;

    template <class... Given> decltype(auto) update(Given&&... given) {
        During const during(Part::queue, Part::rest);
        return Queue::update(std::forward<Given>(given)...);
    }
    template <class... Given> decltype(auto) earliest(Given&&... given) {
        During const during(Part::queue, Part::collision);
        return Queue::earliest(std::forward<Given>(given)...);
    }
    template <class... Given> decltype(auto) rebuild(Given&&... given) {
        During const during(Part::queue, Part::rest);
        return Queue::rebuild(std::forward<Given>(given)...);
    }
};

template <class Real, class Container>
using WatchedPairs = WatchedSearch<EveryPair<Real, Container>>;
template <class Real, class Container>
using WatchedCells = WatchedSearch<CellGrid<Real, Container>>;
template <class Real, class Container>
using WatchedLists = WatchedSearch<NeighbourList<Real, Container>>;
template <class Real> using WatchedTable = WatchedQueue<CollisionTable<Real>>;
template <class Real> using WatchedHeap = WatchedQueue<BinaryHeap<Real>>;
template <class Real> using WatchedCalendar = WatchedQueue<Calendar<Real>>;

/// How often each part was under way at a tick.
inline std::array<std::atomic<std::int64_t>, part_count> ticks_seen{};

/// Counts the part under way at every tick of a clock, as long as it lives.
class PartSampler {
public:
    PartSampler() {
        for (auto& ticks : ticks_seen) ticks = 0;
        struct sigaction action {};
        action.sa_handler = [](int) {
            auto const part = static_cast<std::size_t>(part_under_way.load());
            ticks_seen[part].fetch_add(1, std::memory_order_relaxed);
        };
        action.sa_flags = SA_RESTART;
        sigaction(SIGPROF, &action, nullptr);
        sigevent event{};
        event.sigev_notify = SIGEV_SIGNAL;
        event.sigev_signo = SIGPROF;
        // Processor time is looked at a few hundred times a second only; of the ticks that come
        // while another process has the processor, one is seen.
        if (timer_create(CLOCK_MONOTONIC, &event, &timer_) != 0)
            throw std::runtime_error("parts cannot be sampled: timer_create failed");
        timespec const tick{0, 100'000}; // [s, ns]
        itimerspec const ticks{tick, tick};
        timer_settime(timer_, 0, &ticks, nullptr);
    }
    PartSampler(PartSampler const&) = delete;
    PartSampler& operator=(PartSampler const&) = delete;
    ~PartSampler() {
        timer_delete(timer_);
        std::signal(SIGPROF, SIG_IGN); // one may still be on its way
    }

private:
    timer_t timer_{};
};

/// The shares of the ticks seen so far.
inline Shares shares_seen() {
    double all = 0;
    for (auto const& ticks : ticks_seen) all += static_cast<double>(ticks);
    Shares shares{};
    for (std::size_t k = 0; k < part_count; ++k)
        shares[k] = all > 0 ? static_cast<double>(ticks_seen[k]) / all : 0;
    return shares;
}

template <template <class> class Container, template <class, class> class Search,
          template <class> class Queue>
std::unique_ptr<Engine> watched(System const& system, Start const& start) {
    return std::make_unique<EngineOf<Simulation<double, Container, Search, Queue>>>(
        BallState<double, Container<double>>(system, start,
                                             epoch_length(system, detail::speed_of(start))),
        ModelDescription{});
}

/// The engine of a method, watched.
template <template <class> class Container>
std::unique_ptr<Engine> watched(System const& system, Method const method, Start const& start) {
    switch (method) {
    case Method::table:
        return watched<Container, WatchedPairs, WatchedTable>(system, start);
    case Method::heap:
        return watched<Container, WatchedCells, WatchedHeap>(system, start);
    default:
        return choose_model(system, method, Precision::double_).search == SearchKind::cell_grid
                   ? watched<Container, WatchedCells, WatchedCalendar>(system, start)
                   : watched<Container, WatchedLists, WatchedCalendar>(system, start);
    }
}

/// Where a method's time goes over so many collisions, and for a fortieth of a second at least.
inline Shares shares(System const& system, Method const method, Start const& start,
                     std::uint64_t const collisions) {
    auto const engine = system.boundary == Boundary::walls
                            ? watched<WalledCube>(system, method, start)
                            : watched<PeriodicCube>(system, method, start);
    engine->advance({.ball_collisions = collisions / 4}); // to fill the caches
    PartSampler const sampler;
    double const begin = processor_seconds();
    constexpr double least = 0.025; // [s]
    for (std::uint64_t done = collisions / 4;
         done < collisions || processor_seconds() < begin + least;) {
        done += collisions / 4;
        engine->advance({.ball_collisions = done});
    }
    return shares_seen();
}

/// Ticks of the processor's time stamp counter per second, which it makes at one rate whatever its
/// own; where there is no such counter, nanoseconds stand for cycles.
inline double cycles_per_second() {
#if defined(__x86_64__)
    using Clock = std::chrono::steady_clock;
    auto const begin = Clock::now();
    auto const first = __rdtsc();
    while (Clock::now() - begin < std::chrono::milliseconds(50)) {
    }
    auto const last = __rdtsc();
    return static_cast<double>(last - first) /
           std::chrono::duration<double>(Clock::now() - begin).count();
#else
    return 1e9;
#endif
}

} // namespace clack::validation::speed
