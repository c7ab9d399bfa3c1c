// Many candidates at a time are searched as if one after the other, whatever the scales.

#include "prediction/earliest.hpp"
#include "resolution/elastic_balls.hpp"
#include "tests/made_up_balls.hpp"

#include <boost/test/unit_test.hpp>

#include <numeric>

using namespace clack;
using made_up::uniform;

namespace {

/// A crowd about ball 0: from touching to far, from slow to fast, one in four on a
/// course that grazes it. Scales of length and time are powers of two, from tiny to huge.
template <template <class> class Container> struct Crowd {
    static constexpr std::size_t count = 80; // more than one mask names
    double length, epoch;
    System system;
    Container<double> cube;
    std::vector<Ball<double>> balls;
    std::vector<std::int32_t> numbers;
    ElasticBalls<double> model;
    double now;

    explicit Crowd(std::mt19937_64& random)
        : length(scale(random)),
          epoch(scale(random)), system{.boundary = Container<double>::boundary,
                                       .side = length * uniform(random, 12, 200),
                                       .count = count,
                                       .diameter = length},
          cube(system), balls(count), numbers(count), model(system), now(epoch * uniform(random)) {
        std::iota(numbers.begin(), numbers.end(), 0);
        for (std::size_t k = 0; k < count; ++k) place(balls[k], k, random);
    }

    auto scenery() const {
        return Scenery<double, Container<double>, ElasticBalls<double>>{balls, numbers, cube, model,
                                                                        false};
    }

private:
    static double scale(std::mt19937_64& random) {
        return std::pow(2.0, std::floor(uniform(random, -40, 40)));
    }

    void place(Ball<double>& ball, std::size_t k, std::mt19937_64& random) {
        double const speed = length / epoch * std::pow(10.0, uniform(random, -2, 3));
        Vector3<double> const middle = Vector3<double>::Constant(system.side / 2);
        Vector3<double> const aside = made_up::in_cube(random, -1, 1).normalized();
        double const farthest = std::log10(system.side / length / 8);
        double const away = 1 + std::pow(10.0, uniform(random, -16, farthest));
        ball.time = now * (k % 3 == 0 ? 1 : uniform(random));
        ball.velocity = made_up::in_cube(random, -1, 1) * speed;
        Vector3<double> there = k == 0 ? middle : Vector3<double>(middle + length * away * aside);
        if (k % 4 == 1) { // passes ball 0 at a diameter, a hair more or less
            Vector3<double> across = made_up::in_cube(random, -1, 1);
            across = (across - aside * aside.dot(across)).normalized();
            ball.velocity = balls[0].velocity - across * speed;
            double const hair =
                1 + uniform(random, -1, 1) * std::pow(10.0, uniform(random, -16, -3));
            there = middle + length * (hair * aside +
                                       std::pow(10.0, uniform(random, -1, farthest)) * across);
        }
        ball.point = there - ball.velocity * (now - ball.time);
        if (k % 5 == 3) ball.note = now * (1 + uniform(random));
    }
};

template <template <class> class Container> void search_finds_the_same(unsigned seed) {
    std::mt19937_64 random(seed);
    std::vector<std::int32_t> candidates(Crowd<Container>::count);
    std::iota(candidates.begin(), candidates.end(), 0);
    int found_some = 0;
    for (int k = 0; k < 4000; ++k) {
        Crowd<Container> crowd(random);
        crowd.model.expects_near = k % 2 == 0; // it is right and wrong in that
        auto const scenery = crowd.scenery();
        for (std::int32_t const ball : {0, 1}) {
            auto const expected = earliest_one_by_one(scenery, ball, candidates, crowd.now);
            auto const found = earliest_contact(scenery, ball, candidates, crowd.now);
            BOOST_TEST_REQUIRE(found.ball == expected.ball);
            BOOST_TEST_REQUIRE(found.time == expected.time);
            found_some += found.ball != no_ball;
            // What is known already is found again; what is earlier than all others is not.
            auto const known =
                earliest_contact(scenery, ball, candidates, crowd.now, expected.time);
            BOOST_TEST_REQUIRE(known.ball == expected.ball);
            auto const none =
                earliest_contact(scenery, ball, candidates, crowd.now, expected.time / 2);
            BOOST_TEST_REQUIRE((expected.time == 0 || none.ball == no_ball));
        }
    }
    BOOST_TEST(found_some > 4000);
}

/// Two balls that have just been written, with lists of unequal length, as alone.
template <template <class> class Container> void both_find_the_same(unsigned seed) {
    std::mt19937_64 random(seed);
    std::vector<std::int32_t> all(Crowd<Container>::count);
    std::iota(all.begin(), all.end(), 0);
    std::span<std::int32_t const> const candidates(all);
    int found_some = 0;
    for (int k = 0; k < 4000; ++k) {
        Crowd<Container> crowd(random);
        crowd.model.expects_near = k % 2 == 0; // it is right and wrong in that
        auto const scenery = crowd.scenery();
        for (auto const& [of_first, of_second] :
             {std::pair{16, 16}, {40, 16}, {8, 64}, {80, 24}, {24, 80}}) {
            auto const around_first = candidates.first(static_cast<std::size_t>(of_first));
            auto const around_second = candidates.last(static_cast<std::size_t>(of_second));
            auto const [first, second] =
                earliest_contacts(scenery, 0, around_first, 3, around_second, crowd.now);
            auto const alone = earliest_one_by_one(scenery, 0, around_first, crowd.now);
            auto const also_alone = earliest_one_by_one(scenery, 3, around_second, crowd.now);
            BOOST_TEST_REQUIRE((first.ball == alone.ball && first.time == alone.time));
            BOOST_TEST_REQUIRE((second.ball == also_alone.ball && second.time == also_alone.time));
            found_some += (first.ball != no_ball) + (second.ball != no_ball);
        }
    }
    BOOST_TEST(found_some > 4000);
}

} // namespace

BOOST_AUTO_TEST_CASE(two_balls_side_by_side_find_what_each_finds_alone) {
    both_find_the_same<WalledCube>(5);
    both_find_the_same<PeriodicCube>(6);
}

BOOST_AUTO_TEST_CASE(many_at_a_time_find_what_looking_at_each_finds) {
    search_finds_the_same<WalledCube>(3);
    search_finds_the_same<PeriodicCube>(4);
}

// Who will hit something else before is left out, who will at that very moment is not.
BOOST_AUTO_TEST_CASE(candidates_that_mean_to_touch_something_else_before_are_left_out) {
    System const system{.boundary = Boundary::walls, .side = 20, .count = 3};
    WalledCube<double> const cube(system);
    std::vector<Ball<double>> balls(3);
    balls[0].point = {10, 10, 10};
    balls[1].point = {13, 10, 10}; // is met at 2
    balls[1].velocity = {-1, 0, 0};
    balls[2].point = {10, 14, 10}; // is met at 3
    balls[2].velocity = {0, -1, 0};
    std::vector<std::int32_t> const numbers{0, 1, 2};
    ElasticBalls<double> const model(system);
    Scenery<double, WalledCube<double>, ElasticBalls<double>> const scenery{balls, numbers, cube,
                                                                            model, false};
    std::vector<std::int32_t> const candidates{1, 2, 0, 0, 0, 0, 0, 0};
    auto const partner = [&](double first, double second) {
        balls[1].note = first;
        balls[2].note = second;
        std::int32_t const found = earliest_contact(scenery, 0, candidates, 0.0).ball;
        BOOST_TEST(earliest_one_by_one(scenery, 0, candidates, 0.0).ball == found);
        return found;
    };
    BOOST_TEST(partner(2, 3) == 1);
    BOOST_TEST(partner(1.75, 3) == 2);
    BOOST_TEST(partner(1.75, 2.75) == no_ball);
}

// Equal times go to the lower number, in whatever lane it stands.
BOOST_AUTO_TEST_CASE(ties_go_to_the_lower_number) {
    System const system{.boundary = Boundary::walls, .side = 20, .count = 7};
    WalledCube<double> const cube(system);
    std::vector<Ball<double>> balls(7);
    std::vector<std::int32_t> numbers{3, 6, 5, 2, 4, 1, 0};
    for (std::size_t k = 0; k < 6; ++k) { // six balls come from six sides at one speed
        Vector3<double> const out =
            Vector3<double>::Unit(static_cast<int>(k / 2)) * (k % 2 == 0 ? 1 : -1);
        balls[k + 1].point = Vector3<double>(10, 10, 10) + out * 3;
        balls[k + 1].velocity = -out;
    }
    balls[0].point = Vector3<double>(10, 10, 10);
    ElasticBalls<double> const model(system);
    Scenery<double, WalledCube<double>, ElasticBalls<double>> const scenery{balls, numbers, cube,
                                                                            model, false};
    std::vector<std::int32_t> candidates{4, 1, 2, 6, 3, 5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    auto const found = earliest_contact(scenery, 0, candidates, 0.0);
    BOOST_TEST(found.time == 2);
    BOOST_TEST(found.ball == 6);
}
