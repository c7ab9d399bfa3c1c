#include "cli/schedule.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace clack;

namespace {

Scene scene_with(std::optional<double> time, std::optional<std::uint64_t> collisions,
                 double frame_interval = 0) {
    Scene scene;
    scene.system = {Boundary::walls, 10, 100, 1, 1};
    scene.time = time;
    scene.collisions = collisions;
    scene.frame_interval = frame_interval;
    return scene;
}

/// Walks through a schedule as a run that never collides, or collides only.
std::vector<Sample> walk(Schedule const& schedule, ResumePoint& point, double until) {
    std::vector<Sample> samples;
    while (true) {
        auto const goal = schedule.next_goal(point);
        bool const by_time = std::isfinite(goal.time);
        double const at = by_time ? goal.time : static_cast<double>(goal.ball_collisions);
        if (at > until) break;
        Stop const stop = by_time ? Stop::time : Stop::collisions;
        bool const ended =
            schedule.is_reached(by_time ? at : 0, by_time ? 0 : goal.ball_collisions);
        if (schedule.frame_is_due(point, goal, stop)) ++point.next_frame;
        if (schedule.sample_is_due(point, goal, stop)) {
            ++point.next_sample;
            Sample sample;
            sample.time = by_time ? at : 0;
            sample.tallies.ball_collisions = by_time ? 0 : goal.ball_collisions;
            samples.push_back(sample);
        }
        if (ended) break;
    }
    return samples;
}

} // namespace

BOOST_AUTO_TEST_CASE(between_200_and_400_samples_cover_any_run) {
    for (double const time : {1e-3, 0.77, 20.0, 3.3e9}) {
        ResumePoint point;
        auto const samples = walk(Schedule(scene_with(time, {})), point, time);
        BOOST_TEST(samples.size() >= 200u);
        BOOST_TEST(samples.size() <= 401u);
    }
    for (std::uint64_t const collisions : {200u, 999u, 4'000'000'000u}) {
        ResumePoint point;
        auto const samples = walk(Schedule(scene_with({}, collisions)), point, 1e300);
        BOOST_TEST(samples.size() >= 200u);
        BOOST_TEST(samples.size() <= 401u);
    }
}

BOOST_AUTO_TEST_CASE(frames_come_at_exact_multiples) {
    Schedule const schedule(scene_with(1.0, {}, 0.1));
    for (std::uint64_t k = 0; k < 10; ++k) {
        BOOST_TEST(schedule.frame_time(k) == static_cast<double>(k) * 0.1);
    }
    Schedule const ends_only(scene_with(1.0, {}));
    BOOST_TEST(ends_only.frame_time(0) == 0);
    BOOST_TEST(std::isinf(ends_only.frame_time(1)));
}

BOOST_AUTO_TEST_CASE(collisions_per_ball_count_for_two) {
    auto scene = scene_with({}, {});
    scene.collisions_per_ball = 200;
    scene.equilibrate = 20;
    BOOST_TEST(Schedule(scene).end_collisions() == 10000u);
    BOOST_TEST(Schedule(scene).equilibration() == 1000u);
}

BOOST_AUTO_TEST_CASE(extended_schedule_keeps_the_samples_of_the_longer_one) {
    for (double const longer : {1.3, 2.0, 7.7, 100.0}) {
        Schedule const brief(scene_with(1.0, {})), extended(scene_with(longer, {}));
        ResumePoint point;
        auto samples = walk(brief, point, 1.0);
        point.engine.epoch_length = 1;
        point.engine.offset = {1.0};
        extended.extend(brief, point, samples);
        auto const rest = walk(extended, point, longer);
        samples.insert(samples.end(), rest.begin(), rest.end());

        ResumePoint fresh;
        auto const whole = walk(extended, fresh, longer);
        BOOST_REQUIRE_EQUAL(samples.size(), whole.size());
        for (std::size_t k = 0; k < whole.size(); ++k) {
            BOOST_TEST(samples[k].time == whole[k].time);
        }
    }
}

BOOST_AUTO_TEST_CASE(what_the_end_alone_put_there_goes_when_the_run_is_extended) {
    Schedule const brief(scene_with(1.1, {}, 0.25)), extended(scene_with(5.0, {}, 0.25));
    ResumePoint point;
    auto samples = walk(brief, point, 1.1);
    samples.push_back({1.1, {}, 0});
    point.phase = Phase::finished;
    point.frames = 6; // 0, 0.25 ... 1.0 and 1.1
    point.closing_frames = point.closing_samples = 1;
    point.engine.epoch_length = 1;
    point.engine.epoch = 1;
    point.engine.offset = {0.1};
    extended.extend(brief, point, samples);
    BOOST_TEST((point.phase == Phase::under_way));
    BOOST_TEST(point.frames == 5u);
    BOOST_TEST(point.next_frame == 5u);
    BOOST_TEST(samples.back().time < 1.1);
    BOOST_TEST(extended.next_goal(point).time > 1.1);
}

BOOST_AUTO_TEST_CASE(progress_goes_from_nothing_to_all) {
    Schedule const by_time(scene_with(4.0, {})), by_count(scene_with({}, 1000));
    BOOST_TEST(by_time.progress(1, 999) == 0.25);
    BOOST_TEST(by_count.progress(1, 500) == 0.5);
    BOOST_TEST(Schedule(scene_with(0.0, {})).progress(0, 0) == 1);
}
