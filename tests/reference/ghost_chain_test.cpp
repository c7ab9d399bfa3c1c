#include "reference/ghost_chain.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

using namespace clack::reference;

namespace {

/// The chain followed collision by collision, the slow way.
class FollowedChain {
public:
    FollowedChain(double side, double diameter, std::vector<double> x, std::vector<double> v)
        : side_(side), diameter_(diameter), x_(std::move(x)), v_(std::move(v)) {}

    void follow(double time) {
        for (;;) {
            auto const [wait, where] = next();
            double const step = std::min(wait, time);
            for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += v_[i] * step;
            if (wait > time) return;
            time -= wait;
            collide(where);
        }
    }

    std::vector<double> const& positions() const { return x_; }
    std::vector<double> const& velocities() const { return v_; }
    std::int64_t ball_collisions = 0, wall_collisions = 0;

private:
    /// `where` = i: ball i with its right neighbour, -1 and n - 1: the walls.
    std::pair<double, std::ptrdiff_t> next() const {
        std::pair<double, std::ptrdiff_t> first{std::numeric_limits<double>::infinity(), -2};
        auto const take = [&](double const gap, double const closing, std::ptrdiff_t const where) {
            if (closing > 0 && gap / closing < first.first) first = {gap / closing, where};
        };
        take(x_.front() - diameter_ / 2, -v_.front(), -1);
        for (std::size_t i = 0; i + 1 < x_.size(); ++i)
            take(x_[i + 1] - x_[i] - diameter_, v_[i] - v_[i + 1], static_cast<std::ptrdiff_t>(i));
        take(side_ - diameter_ / 2 - x_.back(), v_.back(), std::ssize(x_) - 1);
        return first;
    }

    void collide(std::ptrdiff_t const where) {
        if (where == -1 || where == std::ssize(x_) - 1) {
            double& v = where == -1 ? v_.front() : v_.back();
            v = -v;
            ++wall_collisions;
        } else {
            std::swap(v_[static_cast<std::size_t>(where)], v_[static_cast<std::size_t>(where) + 1]);
            ++ball_collisions;
        }
    }

    double side_, diameter_;
    std::vector<double> x_, v_;
};

std::vector<double> const places{0.75, 2.25, 3.5, 6.125, 8.0};
std::vector<double> const speeds{0.8125, -1.4375, 0.3125, 1.1875, -0.5625};

} // namespace

BOOST_AUTO_TEST_CASE(ghosts_are_where_the_followed_balls_are) {
    GhostChain const ghosts(10, 1, places, speeds);
    FollowedChain followed(10, 1, places, speeds);
    double const step = 7.3170731; // no collision falls on a multiple of it
    for (int k = 1; k <= 200; ++k) {
        followed.follow(step);
        double const t = k * step;
        auto const x = ghosts.positions(t), v = ghosts.velocities(t);
        for (std::size_t i = 0; i < x.size(); ++i) {
            BOOST_TEST(std::abs(x[i] - followed.positions()[i]) < 1e-10);
            BOOST_TEST(v[i] == followed.velocities()[i]);
        }
        BOOST_TEST(ghosts.ball_collisions(t) == followed.ball_collisions);
        BOOST_TEST(ghosts.wall_collisions(t) == followed.wall_collisions);
    }
    BOOST_TEST(followed.ball_collisions > 1000);
}

BOOST_AUTO_TEST_CASE(two_balls_that_meet_head_on_swap) {
    GhostChain const chain(10, 1, {2, 8}, {1, -1}); // meet at t = 2.5
    BOOST_TEST(chain.ball_collisions(2.4) == 0);
    BOOST_TEST(chain.ball_collisions(2.5) == 1);
    BOOST_TEST(chain.positions(3)[0] == 4);
    BOOST_TEST(chain.positions(3)[1] == 6);
    BOOST_TEST(chain.velocities(3)[0] == -1);
    BOOST_TEST(chain.wall_collisions(3) == 0);
}

BOOST_AUTO_TEST_CASE(chains_that_do_not_fit_are_refused) {
    BOOST_CHECK_THROW(GhostChain(10, 1, {2, 2.9}, {0, 0}), std::invalid_argument);
    BOOST_CHECK_THROW(GhostChain(10, 1, {2, 9.6}, {0, 0}), std::invalid_argument);
    BOOST_CHECK_THROW(GhostChain(10, 1, {0.4}, {0}), std::invalid_argument);
    BOOST_CHECK_THROW(GhostChain(10, 1, {2, 4}, {0}), std::invalid_argument);
}
