#include "state/ball_state.hpp"
#include "state/chained_bins.hpp"
#include "state/container.hpp"
#include "tests/made_up_balls.hpp"

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <set>

using namespace clack;
using Reals = boost::mpl::list<float, double, long double, quad>;

BOOST_AUTO_TEST_CASE_TEMPLATE(limbs_add_up_to_the_number, Real, Reals) {
    std::mt19937_64 random(1);
    for (int k = 0; k < 2000; ++k) {
        Real const x = static_cast<Real>(made_up::uniform(random, -1, 1)) / 3 *
                       static_cast<Real>(std::pow(10.0, made_up::uniform(random, -20, 20)));
        std::vector<double> limbs(static_cast<std::size_t>(limb_count<Real>));
        write_limbs(x, limbs.data());
        std::size_t position = 0;
        BOOST_TEST_REQUIRE((take_limbs<Real>(limbs, position) == x));
        BOOST_TEST_REQUIRE(position == limbs.size());
    }
}

BOOST_AUTO_TEST_CASE(orderless_sum_is_exact_but_for_one_rounding_in_any_order) {
    std::mt19937_64 random(4);
    std::vector<double> terms{0, 5e-324, 1e-310, 0x1p-1022, 1, 0x1p60};
    for (int k = 0; k < 2000; ++k)
        terms.push_back(made_up::uniform(random, 0, 1) *
                        std::pow(10.0, made_up::uniform(random, -12, 12)));
    auto const sum = [&] {
        OrderlessSum total;
        for (double const term : terms) total.add(term);
        return total.value();
    };
    quad reference = 0;
    for (double const term : terms) reference += term;
    double const forwards = sum();
    BOOST_TEST(std::abs(forwards / static_cast<double>(reference) - 1) <= 0x1p-52);
    std::shuffle(terms.begin(), terms.end(), random);
    BOOST_TEST(sum() == forwards);
    terms = {5e-324, 5e-324};
    BOOST_TEST(sum() == 1e-323);
    for (double const bad : {-1.0, infinity<double>, std::nan("")}) {
        terms = {1, bad};
        BOOST_TEST(std::isnan(sum()));
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(nearest_integer_is_odd_and_near, Real, Reals) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 2000; ++k) {
        Real const x = static_cast<Real>(made_up::uniform(random, -1000, 1000));
        Real const n = nearest_integer(x);
        using std::abs;
        using std::floor;
        BOOST_TEST_REQUIRE((abs(n - x) <= Real(0.5)));
        BOOST_TEST_REQUIRE((floor(n) == n));
        BOOST_TEST_REQUIRE((nearest_integer<Real>(-x) == -n));
    }
    BOOST_TEST((nearest_integer(Real(0.5)) == 0));
    BOOST_TEST((nearest_integer(Real(1.5)) == 2));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(wrapped_place_is_in_the_cube_and_laps_add_up, Real, Reals) {
    std::mt19937_64 random(3);
    PeriodicCube<Real> const cube{System{.boundary = Boundary::periodic, .side = 7.7}};
    for (int k = 0; k < 2000; ++k) {
        Vector3<Real> const out = made_up::in_cube<Real>(random, -100, 100);
        Vector3<Real> in = out;
        auto const laps = cube.wrap(in);
        for (int d = 0; d < 3; ++d) {
            BOOST_TEST_REQUIRE((in[d] >= 0 && in[d] <= cube.side));
            using std::abs;
            Real const back =
                in[d] + static_cast<Real>(laps[static_cast<std::size_t>(d)]) * cube.side;
            BOOST_TEST_REQUIRE((abs(back - out[d]) <= 4 * unit_roundoff<Real> * 100));
        }
    }
}

BOOST_AUTO_TEST_CASE(place_a_hair_below_zero_does_not_leave_the_cube) {
    PeriodicCube<double> const cube{System{.boundary = Boundary::periodic, .side = 7.7}};
    Vector3<double> place(-1e-18, 0, 7.7);
    cube.wrap(place);
    BOOST_TEST((place[0] >= 0 && place[0] <= 7.7));
    BOOST_TEST((place[2] >= 0 && place[2] <= 7.7));
}

BOOST_AUTO_TEST_CASE(clock_counts_whole_epochs_and_keeps_the_offset) {
    auto const clock = moment<double>(1e12 + 0.3, 0.25);
    BOOST_TEST(clock.time() == 1e12 + 0.3);
    BOOST_TEST(clock.offset < 0.25);
    BOOST_TEST(moment<double>(infinity<double>, 1).epoch > std::int64_t{1} << 61);
}

BOOST_AUTO_TEST_CASE(memory_order_is_a_permutation_that_brings_neighbours_together) {
    std::mt19937_64 random(4);
    std::vector<Ball<double>> balls(10000);
    for (auto& ball : balls) ball.point = made_up::in_cube(random, 0, 30);
    auto const order = memory_order(balls, 0.0, 30.0);
    auto sorted = order;
    std::sort(sorted.begin(), sorted.end());
    for (std::int32_t k = 0; k < 10000; ++k)
        BOOST_TEST_REQUIRE(sorted[static_cast<std::size_t>(k)] == k);
    auto const roughness = [&] {
        double sum = 0;
        for (std::size_t k = 1; k < balls.size(); ++k)
            sum += (balls[k].point - balls[k - 1].point).norm();
        return sum;
    };
    double const before = roughness();
    reorder(balls, order);
    BOOST_TEST(roughness() < before / 5);
}

BOOST_AUTO_TEST_CASE(bins_that_outgrow_their_room_lose_nobody) {
    ChainedBins<6> bins;
    bins.reset(4);
    bins.insert(1, 7);
    auto const* const before = &bins.block(1);
    for (std::int32_t ball = 100; ball < 1000; ++ball) bins.insert(2, ball);
    BOOST_TEST(before != &bins.block(1)); // they have moved
    BOOST_TEST(bins.block(1).count() == 1);
    BOOST_TEST(bins.block(1).ball[0] == 7);
    std::set<std::int32_t> found;
    bins.drain(2, [&](std::int32_t const* balls, std::size_t count) {
        found.insert(balls, balls + count);
    });
    BOOST_TEST(found.size() == 900u);
    BOOST_TEST(bins.bytes() > 900 / 6 * sizeof *before);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(checkpoint_gives_the_state_back_to_the_last_bit, Real, Reals) {
    System const system = made_up::system(Boundary::periodic, 30, 0.1);
    using State = BallState<Real, PeriodicCube<Real>>;
    State state(system, made_up::lattice(system, 5), 4);
    for (std::int32_t ball = 0; ball < 30; ball += 3) state.fly_to(ball, Real(3) / 7);
    state.clock.offset = Real(3) / 7;
    state.clock.epoch = 12;
    State const back(system, state.checkpoint());
    for (std::int32_t ball = 0; ball < 30; ++ball) {
        BOOST_TEST_REQUIRE((back[ball].point == state[ball].point));
        BOOST_TEST_REQUIRE((back[ball].velocity == state[ball].velocity));
        BOOST_TEST_REQUIRE((back[ball].time == state[ball].time));
    }
    BOOST_TEST(back.images == state.images);
    BOOST_TEST((back.clock.offset == state.clock.offset));
    BOOST_TEST(back.clock.epoch == 12);
}
