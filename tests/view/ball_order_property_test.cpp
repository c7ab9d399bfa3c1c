// What is drawn, how finely, and how long a person waits for it.

#include "tests/scenes/scene_text.hpp"

#include "view/answers.hpp"
#include "view/ball_order.hpp"
#include "view/draft.hpp"
#include "view/fineness.hpp"
#include "view/foresight.hpp"
#include "view/live.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

using namespace clack::view;
using namespace std::chrono_literals;

namespace {

constexpr float radius = 0.03f;

/// Balls at random that do not overlap: 30 % of the cube, so that most hide some others.
Picture made_up_picture() {
    std::mt19937 bits(7);
    std::uniform_real_distribution<float> uniform(radius, 1 - radius);
    Picture picture;
    picture.radius = radius;
    for (int trial = 0; trial < 100'000 && picture.balls.size() < 2500; ++trial) {
        Eigen::Vector3f const place(uniform(bits), uniform(bits), uniform(bits));
        bool const free =
            std::all_of(picture.balls.begin(), picture.balls.end(), [&](DrawnBall const& other) {
                return (Eigen::Vector3f(other.x, other.y, other.z) - place).norm() > 2 * radius;
            });
        if (free) picture.balls.push_back({place.x(), place.y(), place.z(), {}, 0});
    }
    return picture;
}

/// How far along the ray a ball begins; infinite for one that is missed.
float entry(Ray const& ray, DrawnBall const& ball) {
    Eigen::Vector3f const away = Eigen::Vector3f(ball.x, ball.y, ball.z) - ray.origin;
    float const along = away.dot(ray.direction);
    float const aside2 = (away - along * ray.direction).squaredNorm();
    constexpr float rim = 0.999f; // rounding decides who is hit at the very edge
    if (aside2 > rim * radius * radius) return std::numeric_limits<float>::infinity();
    return along - std::sqrt(radius * radius - aside2);
}

DrawnBall const* nearest(std::vector<DrawnBall> const& balls, Ray const& ray) {
    DrawnBall const* found = nullptr;
    for (DrawnBall const& ball : balls) {
        if (!(entry(ray, ball) < std::numeric_limits<float>::infinity())) continue;
        if (!found || entry(ray, ball) < entry(ray, *found)) found = &ball;
    }
    return found;
}

DrawnBall const* first_hit(std::vector<DrawnBall> const& balls, Ray const& ray) {
    for (DrawnBall const& ball : balls) {
        if (entry(ray, ball) < std::numeric_limits<float>::infinity()) return &ball;
    }
    return nullptr;
}

} // namespace

BOOST_AUTO_TEST_CASE(each_ray_of_sight_meets_the_same_ball_first_in_order_as_in_space) {
    auto const picture = made_up_picture();
    PixelSize const size{640, 480};
    for (float const zoom : {1.f, 4.f}) {
        Camera camera;
        camera.fit(size);
        camera.zoom = zoom;
        auto const visible = BallOrder().visible(picture, camera, size);
        BOOST_TEST(visible.dots.empty());
        BOOST_TEST(visible.near.size() < 0.95 * static_cast<double>(picture.balls.size()));
        int wrong = 0, hits = 0;
        for (int k = 0; k < 4000; ++k) {
            auto const ray = camera.ray_through(static_cast<float>(k * 37 % 640) + 0.5f,
                                                static_cast<float>(k * 91 % 480) + 0.5f, size);
            auto const* const in_space = nearest(picture.balls, ray);
            if (!in_space) continue;
            ++hits;
            auto const* const in_order = first_hit(visible.near, ray);
            wrong += !in_order || in_order->x != in_space->x || in_order->y != in_space->y;
        }
        BOOST_TEST(hits > 500);
        BOOST_TEST(wrong == 0);
    }
}

BOOST_AUTO_TEST_CASE(a_draft_has_the_nearest_balls_and_some_of_the_others) {
    Frame many;
    many.system = {clack::Boundary::walls, 100, 125'000};
    many.snapshot.positions.resize(3, many.system.count);
    for (int k = 0; k < many.system.count; ++k)
        many.snapshot.positions.col(k) << 2 * (k % 50) + 1, 2 * (k / 50 % 50) + 1,
            2 * (k / 2500) + 1;
    Camera camera;
    camera.fit({640, 480});
    auto const distance = [&](Eigen::Index ball) {
        return ((many.snapshot.positions.col(ball) / 100).cast<float>() - camera.eye()).norm();
    };
    auto const draft = balls_of_draft(many, Cut{}, camera.eye(), 20'000);
    BOOST_TEST(draft.size() > 15'000u);
    BOOST_TEST(draft.size() < 25'000u);
    constexpr Eigen::Index near = 9'900; // equally far ones about the last may be either
    std::vector<bool> drawn(125'000, false);
    for (auto const ball : draft) drawn[static_cast<std::size_t>(ball)] = true;
    std::vector<Eigen::Index> by_distance(drawn.size());
    std::iota(by_distance.begin(), by_distance.end(), 0);
    std::sort(by_distance.begin(), by_distance.end(),
              [&](auto one, auto other) { return distance(one) < distance(other); });
    auto const is_drawn = [&](Eigen::Index ball) { return drawn[static_cast<std::size_t>(ball)]; };
    BOOST_TEST(std::all_of(by_distance.begin(), by_distance.begin() + near, is_drawn));
    // The farthest too are there, one in so many.
    BOOST_TEST(std::count_if(by_distance.end() - near, by_distance.end(), is_drawn) > near / 20);
    Cut const cut{Face::front, 0.5};
    auto const hidden = [&](Eigen::Index ball) {
        return cut.hides((many.snapshot.positions.col(ball) / 100).cast<float>());
    };
    auto const opened = balls_of_draft(many, cut, camera.eye(), 20'000);
    BOOST_TEST(opened.size() > 15'000u);
    BOOST_TEST(std::none_of(opened.begin(), opened.end(), hidden));
    many.system.count = 20'000;
    BOOST_TEST(balls_of_draft(many, Cut{}, camera.eye(), 20'000).size() == 20'000u);
}

BOOST_AUTO_TEST_CASE(small_balls_are_dots) {
    auto picture = made_up_picture();
    Camera camera;
    camera.fit({40, 30});
    auto const visible = BallOrder().visible(picture, camera, {40, 30});
    BOOST_TEST(visible.near.empty());
    BOOST_TEST(!visible.dots.empty());
}

BOOST_AUTO_TEST_CASE(a_ray_through_a_place_seen_comes_from_there) {
    Camera camera;
    PixelSize const size{500, 400};
    camera.fit(size);
    camera.orbit(0.7f, 0.3f);
    camera.zoom_by(1.7f);
    camera.pan(0.1f, -0.05f);
    Eigen::Vector3f const place(0.3f, 0.6f, 0.45f);
    Eigen::Vector4f const seen =
        camera.projection(size) * Eigen::Vector4f(place.x(), place.y(), place.z(), 1);
    Ray const ray =
        camera.ray_through((seen.x() / seen.w() + 1) * 250, (1 - seen.y() / seen.w()) * 200, size);
    Eigen::Vector3f const away = place - ray.origin;
    BOOST_TEST((away - away.dot(ray.direction) * ray.direction).norm() < 1e-5f);
}

BOOST_AUTO_TEST_CASE(a_cut_hides_what_lies_towards_its_face) {
    for (int face = 0; face < 6; ++face) {
        Cut cut{static_cast<Face>(face), 0.75};
        auto const at = [&](float depth) { // seen from the face
            Eigen::Vector3f place = Eigen::Vector3f::Constant(0.5f);
            place[face / 2] = face % 2 == 0 ? depth : 1 - depth;
            return place;
        };
        BOOST_TEST(cut.hides(at(0.2f)));
        BOOST_TEST(!cut.hides(at(0.3f)));
        BOOST_TEST(!cut.hides(at(1)));
        cut.share = 1;
        BOOST_TEST(!cut.hides(at(-0.1f))); // a ball across the face
    }
}

BOOST_AUTO_TEST_CASE(pictures_that_take_long_are_coarser_at_a_hand_s_touch) {
    Fineness fineness;
    BOOST_TEST(fineness.for_hand() == 1);
    fineness.took(1, 0.08);
    BOOST_TEST(fineness.for_hand() == coarsest);
    BOOST_TEST(fineness.for_time() == 1);
    fineness.took(finest, 0.3); // at rest, with time enough
    BOOST_TEST(fineness.for_hand() == coarsest);
    for (int k = 0; k < 3; ++k) fineness.took(fineness.for_hand(), 0.002);
    BOOST_TEST(fineness.for_hand() == finest);
    BOOST_TEST(fineness.for_time() == finest);
}

BOOST_AUTO_TEST_CASE(a_picture_that_nobody_waits_for_is_left) {
    Picture picture;
    picture.radius = 0.01f;
    picture.balls = {{0.5f, 0.5f, 0.5f, {}, 0}};
    Camera camera;
    camera.fit({640, 480});
    auto const balls = [](VisibleBalls const& visible) {
        return visible.near.size() + visible.dots.size();
    };
    std::stop_source unwanted;
    auto const token = unwanted.get_token();
    BallOrder order;
    BOOST_TEST(balls(order.visible(picture, camera, {640, 480}, token)) == 1u);
    BOOST_TEST(balls(order.prepare(picture, camera, {640, 480}, token).visible) == 1u);
    unwanted.request_stop();
    BOOST_TEST(balls(order.visible(picture, camera, {640, 480}, token)) == 0u);
    BOOST_TEST(balls(order.prepare(picture, camera, {640, 480}, token).visible) == 0u);
}

BOOST_AUTO_TEST_CASE(drafts_that_take_long_have_fewer_balls) {
    Fineness fineness;
    fineness.took(1, 0.03);
    BOOST_TEST(fineness.balls_of_draft() == 20'000u); // a coarser picture comes first
    fineness.took(coarsest, 0.03);
    BOOST_TEST(fineness.balls_of_draft() == 10'000u);
    fineness.took(coarsest, 0.012);
    BOOST_TEST(fineness.balls_of_draft() == 10'000u);
    for (int k = 0; k < 5; ++k) fineness.took(coarsest, 0.03);
    BOOST_TEST(fineness.balls_of_draft() == 2'500u);
    for (int k = 0; k < 3; ++k) {
        BOOST_TEST(fineness.for_hand() == coarsest);
        fineness.took(coarsest, 0.002);
    }
    BOOST_TEST(fineness.balls_of_draft() == 20'000u);
    fineness.took(coarsest, 0.002);
    BOOST_TEST(fineness.for_hand() == 1);
}

BOOST_AUTO_TEST_CASE(an_answer_is_the_wait_for_the_picture_that_shows_it) {
    Answers answers;
    Answers::Clock::time_point const start;
    answers.ask(start);
    answers.ask(start + 10ms);
    answers.answer(0, start + 20ms); // a picture that was under way before
    BOOST_TEST(answers.longest() == 0);
    answers.answer(1, start + 30ms);
    answers.answer(2, start + 50ms);
    BOOST_TEST(std::abs(answers.longest() - 0.04) < 1e-12);
    BOOST_TEST(answers.longest() == 0);
    BOOST_TEST(answers.asked() == 2u);
}

BOOST_AUTO_TEST_CASE(a_step_back_after_long_play_does_not_begin_at_the_start) {
    Live source(clack::parse_scene("[container]\nboundary = \"walls\"\npacking_fraction = 0.3\n"
                                   "[balls]\ncount = 64\narrangement = \"grid\"\n"
                                   "[velocities]\ndistribution = \"maxwell\"\n"
                                   "[run]\nseed = 5\ntime = 1.0\n",
                                   "gas.toml"));
    auto const cpu_seconds = [](auto const& work) {
        auto const begin = std::clock();
        work();
        return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    };
    // In steps as short as a player's, in each of which little happens.
    auto const played = cpu_seconds([&] {
        for (double time = 0; source.history()->total() < 400'000; time += 0.01)
            source.advance(time);
    });
    auto const before = source.history()->total();
    auto const back = cpu_seconds([&] { BOOST_TEST(source.step_back()); });
    BOOST_TEST(source.history()->total() >= before - 1);
    BOOST_TEST(back < played / 2); // one third of the way at most
}

BOOST_AUTO_TEST_CASE(a_search_that_ends_too_late_is_followed_by_another) {
    using namespace clack::test;
    auto const many = changed(correct_scene, "count = 100", "count = 4000");
    Live source(clack::parse_scene(changed(many, "20.0", "40.0"), "scene.toml"));
    Foresight foresight;
    auto frame = frame_of(source, nullptr);
    foresight.tell(source, 0, frame);
    std::this_thread::sleep_for(200ms); // it ends
    std::uint64_t const tasks = 1;      // asked meanwhile
    bool told = foresight.tell(source, tasks, frame);
    for (int wait = 0; wait < 400 && !told; ++wait) {
        std::this_thread::sleep_for(10ms);
        told = foresight.has_news() && foresight.tell(source, tasks, frame);
    }
    BOOST_TEST(told);
    BOOST_TEST(frame.next.has_value());
}
