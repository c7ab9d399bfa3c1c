// What the window shows, without a window: the player, the meter, the physics, what is asked for.

#include "tests/cli/program.hpp"
#include "tests/scenes/scene_text.hpp"

#include "view/live.hpp"
#include "view/session.hpp"

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <cmath>
#include <numeric>
#include <thread>

using namespace clack;
using namespace clack::test;
using namespace clack::view;

namespace {

using namespace std::chrono_literals;

Folder const folder;

std::string const gas = R"([container]
boundary = "walls"
packing_fraction = 0.1
[balls]
count = 64
arrangement = "grid"
[velocities]
distribution = "maxwell"
[run]
seed = 5
time = 10.0
)";

std::unique_ptr<Live> live() { return std::make_unique<Live>(parse_scene(gas, "gas.toml")); }

/// A source of one ball that passes time as slowly as it is told, or goes from frame to frame.
class MadeUp final : public Source {
public:
    double rate = 1e9;     // simulated time in a second that it can do at most
    double frame_wait = 0; // time between frames; 0: at any time
    double end = 1e9;

    System const& system() const override { return system_; }
    double time() const override { return time_; }
    double first_time() const override { return 0; }
    double last_time() const override { return end; }
    Progress advance(double until) override {
        constexpr double slice = 0.002; // [s]
        if (until > time_ + rate * slice) {
            std::this_thread::sleep_for(std::chrono::duration<double>(slice));
            time_ += rate * slice;
            return Progress::under_way;
        }
        time_ = frame_wait > 0 ? frame_wait * std::floor(until / frame_wait) : until;
        return Progress::arrived;
    }
    void seek(double to) override { time_ = to; }
    bool step() override { return false; }
    bool step_back() override { return false; }
    Snapshot snapshot() const override {
        return {time_, 0, Eigen::Matrix3Xd::Zero(3, 1), Eigen::Matrix3Xd::Zero(3, 1), {}};
    }
    Sample sample() const override { return {time_, {}, 0}; }
    History const* history() const override { return nullptr; }
    void trace(std::int64_t) override {}
    Search search(std::optional<std::int64_t>) override {
        return [] { return std::nullopt; };
    }
    Eigen::Matrix3Xd const& start_places() const override { return places_; }
    std::string description() const override { return "made up"; }

private:
    System system_{Boundary::walls, 10, 1};
    double time_ = 0;
    Eigen::Matrix3Xd places_ = Eigen::Matrix3Xd::Zero(3, 1);
};

/// What is shown once that is so, and all that was asked for is done; at most 20 s later.
template <class Condition>
std::shared_ptr<Shown const> shown_when(Player& player, Condition const& condition) {
    auto const end = std::chrono::steady_clock::now() + 20s;
    auto shown = player.latest();
    while (std::chrono::steady_clock::now() < end &&
           !(player.has_done_all(*shown) && condition(*shown))) {
        player.want_news();
        std::this_thread::sleep_for(2ms);
        shown = player.latest();
    }
    return shown;
}

std::shared_ptr<Shown const> shown_when_done(Player& player) {
    return shown_when(player, [](Shown const&) { return true; });
}

bool same_bits(Snapshot const& one, Snapshot const& other) {
    return one.time == other.time && one.positions == other.positions &&
           one.velocities == other.velocities;
}

/// So many balls of the gas, with Maxwell's speeds or equal ones.
Frame frame_with_speeds(std::int64_t count, bool maxwell) {
    auto const text = changed(changed(gas, "count = 64", "count = " + std::to_string(count)),
                              "\"maxwell\"", maxwell ? "\"maxwell\"" : "\"equal_speed\"");
    Live const source(parse_scene(text, "gas.toml"));
    return frame_of(source, nullptr);
}

} // namespace

BOOST_AUTO_TEST_CASE(the_speed_is_simulated_time_over_seconds) {
    Meter meter;
    Meter::Clock::time_point const start;
    meter.begin(start, {10, 100});
    meter.add_engine_seconds(0.25);
    meter.add_engine_seconds(0.25);
    BOOST_TEST(!meter.read(start + 400ms, {10.1, 120}));
    auto const slow = meter.read(start + 2s, {10.5, 300});
    BOOST_REQUIRE(slow);
    BOOST_TEST(slow->speed == 0.25);
    BOOST_TEST(slow->collisions_per_second == 100);
    BOOST_TEST(slow->engine_share == 0.25);
    auto const sought_back = meter.read(start + 3s, {0, 10});
    BOOST_TEST(sought_back->speed == 0);
    BOOST_TEST(sought_back->collisions_per_second == 0);
    BOOST_TEST(sought_back->engine_share == 0);
    BOOST_TEST(meter.read(start + 4s, {1, 10})->speed == 1);
}

BOOST_AUTO_TEST_CASE(what_cannot_keep_up_is_shown_as_slow_as_it_is) {
    auto source = std::make_unique<MadeUp>();
    source->rate = 0.25;
    Player player(std::move(source), 4);
    auto const begin = std::chrono::steady_clock::now();
    player.play();
    auto const shown = shown_when(player, [](Shown const& now) { return now.rates.speed > 0; });
    std::chrono::duration<double> const passed = std::chrono::steady_clock::now() - begin;
    BOOST_TEST(shown->speed == 4);
    BOOST_TEST(shown->rates.speed > 0);
    BOOST_TEST(shown->rates.speed < 0.26);
    BOOST_TEST(shown->frame.snapshot.time < 0.26 * passed.count());
}

BOOST_AUTO_TEST_CASE(a_file_of_frames_goes_on_at_its_speed_however_far_apart_they_are) {
    auto source = std::make_unique<MadeUp>();
    source->frame_wait = 0.5; // longer than a source that computes may fall behind
    Player player(std::move(source), 2);
    player.play();
    auto const shown = shown_when(player, [](Shown const& now) {
        return now.frame.snapshot.time >= 1 && now.rates.speed > 0;
    });
    BOOST_TEST(shown->frame.snapshot.time >= 1);
    BOOST_TEST(std::fmod(shown->frame.snapshot.time, 0.5) == 0);
    BOOST_TEST(shown->rates.speed > 0);
    BOOST_TEST(shown->rates.speed < 2.21); // what a twentieth of a second was late may be in it
}

BOOST_AUTO_TEST_CASE(playing_stops_at_the_end) {
    auto source = std::make_unique<MadeUp>();
    source->end = 0.05;
    Player player(std::move(source), 1);
    player.play();
    auto const shown = shown_when(player, [](Shown const& now) {
        return now.frame.snapshot.time > 0 && now.playing == Playing::no;
    });
    BOOST_TEST((shown->playing == Playing::no));
    BOOST_TEST(shown->frame.snapshot.time == 0.05);
}

BOOST_AUTO_TEST_CASE(steps_back_and_a_return_in_time_replay_exactly) {
    auto const source = live();
    source->seek(1.25);
    auto const at_rest = source->snapshot();
    std::vector<Snapshot> states;
    for (int k = 0; k < 40; ++k) {
        BOOST_REQUIRE(source->step());
        states.push_back(source->snapshot());
    }
    for (std::size_t k = states.size() - 1; k-- > 0;) {
        BOOST_REQUIRE(source->step_back());
        BOOST_TEST(same_bits(source->snapshot(), states[k]));
    }
    source->seek(3);
    source->seek(1.25);
    BOOST_TEST(same_bits(source->snapshot(), at_rest));
    source->seek(0);
    BOOST_TEST(!source->step_back());
}

BOOST_AUTO_TEST_CASE(speeds_are_judged_by_their_exact_law) {
    auto const fluid = physics_of(frame_with_speeds(4096, true), {});
    BOOST_REQUIRE(fluid.speed_test);
    constexpr double false_alarm = 1e-6; // the seed is fixed: once for all
    BOOST_TEST(fluid.speed_test->p_value > false_alarm);
    auto const equal = physics_of(frame_with_speeds(4096, false), {});
    BOOST_TEST(equal.speed_test->p_value < false_alarm);
    auto const& speeds = fluid.speeds;
    double const width = speeds.top / static_cast<double>(speeds.measured.size());
    double const measured = std::accumulate(speeds.measured.begin(), speeds.measured.end(), 0.0);
    BOOST_TEST(std::abs(measured * width - 1) < 0.002); // hardly any ball is faster than the top
    double const step = speeds.top / static_cast<double>(speeds.exact.size() - 1);
    double const exact = std::accumulate(speeds.exact.begin(), speeds.exact.end(), 0.0);
    BOOST_TEST(std::abs(exact * step - 1) < 0.002);
    BOOST_TEST(!physics_of(frame_with_speeds(8, true), {}).speed_test); // too few balls
}

BOOST_AUTO_TEST_CASE(z_and_its_course_are_those_of_the_samples) {
    auto frame = frame_with_speeds(64, true);
    double const kt = 1, side = frame.system.accessible_side();
    std::vector<Sample> samples;
    for (int k = 0; k <= 200; ++k) {
        double const time = 0.1 * k;
        samples.push_back({time, {}, 1.5 * 64 * kt});
        samples.back().tallies.virial = 3 * 64 * kt * 0.5 * time;               // Z = 1.5
        samples.back().tallies.wall_impulse = 6 * 64 * kt * 1.25 * time / side; // Z = 1.25
    }
    frame.sample = samples.back();
    auto const physics = physics_of(frame, samples);
    BOOST_TEST(std::abs(physics.compressibility_factor.virial->value - 1.5) < 1e-12);
    BOOST_TEST(std::abs(physics.compressibility_factor.wall->value - 1.25) < 1e-12);
    BOOST_REQUIRE(physics.course.size() > 20u);
    for (auto const& point : physics.course)
        BOOST_TEST(std::abs(point.factor.virial->value - 1.5) < 1e-12);
    BOOST_TEST(physics.course.back().time == samples.back().time);
    BOOST_TEST(physics.course.front().time < 1);
    auto const range = range_of(physics);
    BOOST_REQUIRE(physics.theory);
    BOOST_TEST(range.low < std::min(1.25, physics.theory->value));
    BOOST_TEST(range.high > std::max(1.5, physics.theory->value));
}

BOOST_AUTO_TEST_CASE(z_is_not_told_before_a_collision_nor_theory_for_a_handful_of_balls) {
    auto const frame = frame_with_speeds(64, true);
    std::vector<Sample> const samples{{0, {}, 96}, {1, {}, 96}, {2, {}, 96}};
    auto const physics = physics_of(frame, samples);
    auto const& factor = physics.compressibility_factor;
    BOOST_TEST((!factor.virial && !factor.wall && physics.theory));
    auto few = frame_with_speeds(8, true);
    few.system.side = 10; // so dilute that a theory of fluids would answer
    BOOST_TEST(!physics_of(few, {}).theory);
}

BOOST_AUTO_TEST_CASE(z_has_samples_however_seldom_frames_are_asked_for) {
    Player player(live(), 1);
    player.play();
    auto const played = [](Shown const& now) { return now.playing == Playing::yes; };
    BOOST_REQUIRE(played(*shown_when(player, played)));
    std::this_thread::sleep_for(1s);
    auto const shown =
        shown_when(player, [](Shown const& now) { return now.frame.snapshot.time > 0.5; });
    BOOST_TEST(shown->physics.course.size() > 8u);
}

BOOST_AUTO_TEST_CASE(of_many_balls_the_next_collision_is_told_after_the_picture) {
    auto source =
        std::make_unique<Live>(parse_scene(changed(gas, "count = 64", "count = 4096"), "gas.toml"));
    Player player(std::move(source), 1);
    player.step();
    auto shown = shown_when_done(player);
    BOOST_TEST(shown->frame.snapshot.time > 0);
    shown = shown_when(player, [&](Shown const& now) { return player.is_settled(now); });
    BOOST_REQUIRE(shown->frame.next);
    double const foretold = shown->frame.next->time;
    player.step();
    BOOST_TEST(shown_when_done(player)->frame.snapshot.time == foretold);
}

BOOST_AUTO_TEST_CASE(a_scene_that_does_not_fit_is_told_and_the_old_one_stays) {
    Options options;
    options.path = folder.write("gas.toml", gas);
    options.require_room = [](Scene const& scene) {
        if (scene.system.count > 1000) throw InputError("count = 1001: needs more than there is");
    };
    Session session(options, live());
    session.choice.count = 1001;
    session.restart();
    auto shown = shown_when_done(session.player);
    BOOST_TEST(shown->message == "count = 1001: needs more than there is");
    BOOST_TEST(shown->frame.system.count == 64);
    session.choice.count = 125;
    session.restart();
    shown = shown_when_done(session.player);
    BOOST_TEST(shown->message.empty());
    BOOST_TEST(shown->frame.system.count == 125);
}

BOOST_AUTO_TEST_CASE(the_cut_goes_from_face_to_face) {
    Options options;
    options.path = folder.write("gas.toml", gas);
    Session session(options, live());
    session.cut_from_next_face();
    BOOST_TEST((session.look.cut == Cut{Face::back, 0.5}));
    session.toggle_cut();
    BOOST_TEST(session.look.cut.is_whole());
}
