#include "neighbours/cell_grid.hpp"
#include "neighbours/every_pair.hpp"
#include "neighbours/neighbour_list.hpp"
#include "prediction/contact.hpp"
#include "tests/made_up_balls.hpp"

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <set>

using namespace clack;

namespace {

template <class Real> using Walled = WalledCube<Real>;
template <class Real> using Periodic = PeriodicCube<Real>;

using Searches =
    boost::mpl::list<EveryPair<double, Walled<double>>, EveryPair<double, Periodic<double>>,
                     CellGrid<double, Walled<double>>, CellGrid<double, Periodic<double>>,
                     NeighbourList<double, Walled<double>>, NeighbourList<double, Periodic<double>>,
                     CellGrid<float, Walled<float>>, NeighbourList<float, Periodic<float>>>;

template <class Search> struct Parts;
template <template <class, class> class Search, class Real_, class Container_>
struct Parts<Search<Real_, Container_>> {
    using Real = Real_;
    using Container = Container_;
};

/// Balls that fly freely, through one another, so that any pair may come near at any time.
template <class Search> struct Crowd {
    using Real = typename Parts<Search>::Real;
    using Container = typename Parts<Search>::Container;

    System system;
    Container cube{system};
    Search search{system, cube};
    std::vector<Ball<Real>> balls;
    std::vector<Real> expiry;

    Crowd(System const& made, std::uint64_t seed) : system(made) {
        std::mt19937_64 random(seed);
        double const low = static_cast<double>(cube.origin());
        double const high = low + static_cast<double>(cube.extent());
        for (std::int64_t k = 0; k < system.count; ++k) {
            Ball<Real> ball{};
            ball.point = made_up::in_cube<Real>(random, low, high);
            ball.velocity = made_up::in_cube<Real>(random, -1, 1);
            balls.push_back(ball);
        }
        search.rebuild(balls, 0);
        for (std::int32_t k = 0; k < static_cast<std::int32_t>(balls.size()); ++k)
            expiry.push_back(search.expiry(balls, k, 0));
    }

    bool listed(std::int32_t i, std::int32_t j) {
        auto const candidates = search.candidates(i);
        BOOST_TEST_REQUIRE(candidates.size() % lane_count == 0);
        return std::find(candidates.begin(), candidates.end(), j) != candidates.end();
    }

    Real distance(std::int32_t i, std::int32_t j, Real now) const {
        Pair<Real> const pair = pair_of(balls[static_cast<std::size_t>(i)],
                                        balls[static_cast<std::size_t>(j)], cube, now);
        Real const wait = now - pair.time;
        Vector3<Real> const r{pair.x + pair.vx * wait, pair.y + pair.vy * wait,
                              pair.z + pair.vz * wait};
        return r.norm();
    }

    /// The laws of the concept at one moment.
    void check(Real now) {
        auto const count = static_cast<std::int32_t>(balls.size());
        for (std::int32_t i = 0; i < count; ++i) {
            for (std::int32_t j = 0; j < count; ++j) {
                if (i == j || distance(i, j, now) > static_cast<Real>(system.diameter)) continue;
                BOOST_TEST_REQUIRE(listed(i, j));
                ++near_pairs;
            }
        }
    }

    void refresh_next() {
        auto const first = std::min_element(expiry.begin(), expiry.end());
        auto const ball = static_cast<std::int32_t>(first - expiry.begin());
        Real const now = *first;
        BOOST_TEST_REQUIRE((now >= latest));
        latest = now;
        bounce_those_at_walls(now);
        auto const had = search.candidates(ball);
        std::vector<std::int32_t> const before(had.begin(), had.end());
        auto const fresh = search.refresh(balls, ball, now);
        std::vector<std::int32_t> const told(fresh.begin(), fresh.end());
        for (std::int32_t const j : search.candidates(ball)) {
            bool const old = std::find(before.begin(), before.end(), j) != before.end();
            BOOST_TEST_REQUIRE((old || std::find(told.begin(), told.end(), j) != told.end()));
        }
        *first = search.expiry(balls, ball, now);
    }

    /// A ball flies on another way, as after a collision.
    void turn_one(std::mt19937_64& random) {
        auto const k = static_cast<std::int32_t>(random() % balls.size());
        Ball<Real>& ball = balls[static_cast<std::size_t>(k)];
        ball.point = ball.position(latest);
        cube.wrap(ball.point);
        ball.velocity = made_up::in_cube<Real>(random, -1, 1);
        ball.time = latest;
        search.settle(balls, k);
        expiry[static_cast<std::size_t>(k)] = search.expiry(balls, k, latest);
    }

    /// Walls end a flight before a search notices.
    void bounce_those_at_walls(Real now) {
        if constexpr (Container::boundary == Boundary::walls) {
            for (std::size_t k = 0; k < balls.size(); ++k) {
                Ball<Real>& ball = balls[k];
                Vector3<Real> const place = ball.position(now);
                for (int d = 0; d < 3; ++d) {
                    if ((place[d] >= cube.low || ball.velocity[d] > 0) &&
                        (place[d] <= cube.high || ball.velocity[d] < 0))
                        continue;
                    ball.point = place;
                    ball.point[d] = place[d] < cube.low ? cube.low : cube.high;
                    ball.velocity[d] = -ball.velocity[d];
                    ball.time = now;
                    expiry[k] = search.expiry(balls, static_cast<std::int32_t>(k), now);
                }
            }
        }
    }

    Real latest = 0;
    long near_pairs = 0;
};

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(near_pairs_are_candidates_of_each_other_at_all_times, Search,
                              Searches) {
    for (double const packing_fraction : {0.02, 0.06}) {
        Crowd<Search> crowd(
            made_up::system(Crowd<Search>::Container::boundary, 90, packing_fraction), 11);
        if constexpr (requires { Search::fits(crowd.system); })
            BOOST_TEST_REQUIRE(Search::fits(crowd.system));
        std::mt19937_64 random(12);
        crowd.check(0);
        for (int k = 0; k < 600; ++k) {
            if (std::isinf(static_cast<double>(
                    *std::min_element(crowd.expiry.begin(), crowd.expiry.end()))))
                break;
            crowd.refresh_next();
            crowd.turn_one(random);
            if (k % 10 == 0) crowd.check(crowd.latest);
        }
        BOOST_TEST(crowd.near_pairs > 10);
    }
}

using ListSearches =
    boost::mpl::list<NeighbourList<double, Walled<double>>, NeighbourList<double, Periodic<double>>,
                     NeighbourList<float, Periodic<float>>>;

BOOST_AUTO_TEST_CASE_TEMPLATE(two_shells_at_once_end_when_they_end_one_by_one, Search,
                              ListSearches) {
    using Parts = Parts<Search>;
    using Real = typename Parts::Real;
    Crowd<Search> crowd(made_up::system(Parts::Container::boundary, 200, 0.2), 7);
    std::size_t const last = crowd.balls.size() - 1;
    crowd.balls[0].velocity.setZero();           // stays for ever
    crowd.balls[1].point = crowd.balls[0].point; // is not where its shell is
    Real const now = Real(0.25);
    for (std::size_t k = 0; k < last; ++k) {
        crowd.balls[k].time = crowd.balls[k + 1].time = now;
        auto const i = static_cast<std::int32_t>(k), j = i + 1;
        auto const [of_i, of_j] = crowd.search.expiries(crowd.balls, i, j, now);
        BOOST_TEST_REQUIRE(of_i == crowd.search.expiry(crowd.balls, i, now));
        BOOST_TEST_REQUIRE(of_j == crowd.search.expiry(crowd.balls, j, now));
    }
    BOOST_TEST(crowd.search.expiry(crowd.balls, 0, now) == infinity<Real>);
    BOOST_TEST(crowd.search.expiry(crowd.balls, 1, now) == now);
}

/// Through which image balls of adjacent cells touch is what the nearest one tells.
BOOST_AUTO_TEST_CASE(balls_stray_no_farther_than_adjacent_cells_are_less_than_half_a_side_wide) {
    System const system = made_up::system(Boundary::periodic, 40, 0.001);
    PeriodicCube<double> const cube(system);
    CellGrid<double, PeriodicCube<double>> search(system, cube);
    std::vector<Ball<double>> balls(40);
    balls[0].point.setConstant(system.side / 2); // the middle of a cell
    balls[0].velocity = {1, 0, 0};
    search.rebuild(balls, 0);
    double const cell = system.side / 5;
    double const stray = search.expiry(balls, 0, 0) - cell / 2;
    BOOST_TEST(stray > 1);
    BOOST_TEST(2 * (cell + stray) < system.side / 2);
}

/// All balls in one corner of a large box: chains of blocks, wide lists, nothing overflows.
BOOST_AUTO_TEST_CASE(a_crowded_cell_holds_any_number) {
    CellBins<3> bins(Boundary::walls, 3, 500);
    std::mt19937_64 random(1);
    std::vector<Cell> where(500);
    for (int round = 0; round < 4000; ++round) {
        auto const ball = static_cast<std::int32_t>(random() % 500);
        auto& cell = where[static_cast<std::size_t>(ball)];
        if (round >= 500) bins.remove(round < 1000 ? round - 500 : ball);
        if (round < 500) {
            where[static_cast<std::size_t>(round)] = {1, 1, 1};
            bins.insert(round, {1, 1, 1});
        } else {
            std::int32_t const moved = round < 1000 ? round - 500 : ball;
            where[static_cast<std::size_t>(moved)] = {static_cast<std::int32_t>(random() % 3), 1,
                                                      1};
            bins.insert(moved, where[static_cast<std::size_t>(moved)]);
        }
        (void)cell;
    }
    for (std::int32_t x = 0; x < 3; ++x) {
        BallBuffer found; // the face of cells that holds the cell in question and empty ones
        bins.collect_beyond({x == 1 ? 0 : 1, 1, 1}, 0, x == 0 ? -1 : 1, found);
        std::vector<std::int32_t> got(found.begin(), found.end()), wanted;
        std::sort(got.begin(), got.end());
        for (std::int32_t ball = 0; ball < 500; ++ball)
            if (where[static_cast<std::size_t>(ball)][0] == x) wanted.push_back(ball);
        BOOST_TEST(got == wanted, boost::test_tools::per_element());
    }
    BallBuffer all;
    bins.collect_around({1, 1, 1}, all);
    BOOST_TEST(all.size() == 500u);
}

BOOST_AUTO_TEST_CASE(lists_that_outgrow_their_rows_lose_nobody) {
    using Lists = NeighbourList<double, WalledCube<double>>;
    Crowd<Lists> crowd(made_up::system(Boundary::walls, 60, 0.01), 5);
    for (std::int32_t k = 1; k < 60; ++k) { // all to one place, but for ball 0
        crowd.balls[static_cast<std::size_t>(k)].point.setConstant(crowd.cube.low);
        crowd.search.refresh(crowd.balls, k, 0);
    }
    for (std::int32_t k = 1; k < 60; ++k) {
        auto const found = crowd.search.candidates(k);
        std::set<std::int32_t> const others(found.begin(), found.end());
        BOOST_TEST(others.size() >= 59u); // with itself
    }
}
