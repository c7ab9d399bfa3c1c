#include "observables/event_replay.hpp"
#include "simulation/engine.hpp"
#include "state/real.hpp"

#include <boost/test/unit_test.hpp>

#include <functional>
#include <vector>

using namespace clack;

namespace {

struct Keep final : CollisionObserver {
    std::vector<Collision<double>> events;
    void operator()(Collision<double> const& collision) override { events.push_back(collision); }
};

struct Record {
    System system{Boundary::walls, 6, 27, 1, 1};
    double epoch_length = 0;
    Snapshot first, last;
    std::vector<Collision<double>> events;

    EventReplay::Findings replay() const {
        EventReplay replay(system, epoch_length, unit_roundoff<double>, first);
        for (auto const& event : events) replay.add_event(event);
        replay.add_frame(last);
        return replay.findings();
    }
};

/// A real run of 27 balls.
Record recorded(Boundary boundary) {
    Record record;
    record.system.boundary = boundary;
    Start start{Eigen::Matrix3Xd(3, 27), Eigen::Matrix3Xd(3, 27)};
    for (int i = 0; i < 27; ++i) {
        start.positions.col(i) << 1 + 2 * (i % 3), 1 + 2 * (i / 3 % 3), 1 + 2 * (i / 9);
        start.velocities.col(i) << (i * 7) % 11 - 5, (i * 5) % 13 - 6, (i * 3) % 7 - 3;
    }
    auto const engine = make_engine(record.system, Method::automatic, Precision::double_, start);
    record.first = engine->snapshot();
    Keep keep;
    Goal goal;
    goal.ball_collisions = 2000;
    engine->advance(goal, &keep);
    record.events = keep.events;
    record.last = engine->snapshot();
    record.epoch_length = engine->checkpoint().epoch_length;
    return record;
}

bool any_broken(EventReplay::Findings const& findings) {
    return findings.order.is_broken() || findings.contact.is_broken() ||
           findings.exchange.is_broken() || findings.frames.is_broken();
}

} // namespace

BOOST_AUTO_TEST_CASE(true_run_keeps_every_law) {
    for (auto const boundary : {Boundary::walls, Boundary::periodic}) {
        auto const findings = recorded(boundary).replay();
        BOOST_TEST(!any_broken(findings));
        BOOST_TEST(findings.contact.worst > 0);
        BOOST_TEST(findings.contact.worst < 0.5);
        BOOST_TEST(findings.frames.worst < 0.5);
    }
}

BOOST_AUTO_TEST_CASE(each_tampering_is_caught) {
    auto const truth = recorded(Boundary::walls);
    struct Tampering {
        char const* what;
        std::function<void(Record&)> apply;
        Departure EventReplay::Findings::*found;
    };
    using Findings = EventReplay::Findings;
    std::vector<Tampering> const tamperings{
        {"an event later by 1e-9", [](Record& r) { r.events[700].offset += 1e-9; },
         &Findings::contact},
        {"two events swapped", [](Record& r) { std::swap(r.events[700], r.events[701]); },
         &Findings::order},
        {"an event lost", [](Record& r) { r.events.erase(r.events.begin() + 700); },
         &Findings::contact},
        {"a velocity wrong by 1e-9", [](Record& r) { r.events[700].velocity_first[0] *= 1 + 1e-9; },
         &Findings::exchange},
        {"a diameter wrong by 1e-6", [](Record& r) { r.system.diameter *= 1 + 1e-6; },
         &Findings::contact},
        {"a wall off by 1e-6", [](Record& r) { r.system.side *= 1 + 1e-6; }, &Findings::contact},
        {"a ball that does not exist", [](Record& r) { r.events[700].first = 27; },
         &Findings::order},
        {"a place in the last frame off by 1e-9",
         [](Record& r) { r.last.positions(1, 13) += 1e-9; }, &Findings::frames},
        {"a velocity in the last frame off by its last bit",
         [](Record& r) { r.last.velocities(1, 13) *= 1 + 0x1p-51; }, &Findings::frames}};
    for (auto const& tampering : tamperings) {
        auto record = truth;
        tampering.apply(record);
        auto const findings = record.replay();
        BOOST_TEST_CONTEXT(tampering.what) {
            BOOST_TEST((findings.*tampering.found).is_broken());
            BOOST_TEST(!(findings.*tampering.found).where.empty());
        }
    }
}
