#include "resolution/bounce.hpp"
#include "tests/made_up_balls.hpp"

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

using namespace clack;
using Reals = boost::mpl::list<float, double, long double, quad>;

namespace {

template <class Real> struct Hit {
    Vector3<Real> separation, before_i, before_j, after_i, after_j, impulse;

    explicit Hit(std::mt19937_64& random) {
        separation = made_up::in_cube(random, -1, 1).normalized().template cast<Real>();
        before_i = made_up::in_cube<Real>(random, -1, 1);
        before_j = made_up::in_cube<Real>(random, -1, 1);
        if (dot<Real>(separation, before_j - before_i) > 0) std::swap(before_i, before_j);
        after_i = before_i;
        after_j = before_j;
        impulse = exchange_normal_velocities(after_i, after_j, separation);
    }
};

template <class Real> Real largest(Vector3<Real> const& v) { return v.cwiseAbs().maxCoeff(); }

} // namespace

/// Every component of a velocity is below 1 and is rounded a handful of times: 16 roundings.
BOOST_AUTO_TEST_CASE_TEMPLATE(momentum_and_energy_stay, Real, Reals) {
    std::mt19937_64 random(1);
    for (int k = 0; k < 5000; ++k) {
        Hit<Real> const hit(random);
        Vector3<Real> const gained = hit.after_i + hit.after_j - hit.before_i - hit.before_j;
        BOOST_TEST_REQUIRE((largest(gained) <= 16 * unit_roundoff<Real>));
        Real const energy =
            dot<Real>(hit.before_i, hit.before_i) + dot<Real>(hit.before_j, hit.before_j);
        Real const kept = dot<Real>(hit.after_i, hit.after_i) + dot<Real>(hit.after_j, hit.after_j);
        using std::abs;
        BOOST_TEST_REQUIRE((abs(kept - energy) <= 64 * unit_roundoff<Real>));
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(normal_components_are_exchanged_and_the_rest_stays, Real, Reals) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 5000; ++k) {
        Hit<Real> const hit(random);
        using std::abs;
        using std::sqrt;
        Vector3<Real> const n = hit.separation / sqrt(dot<Real>(hit.separation, hit.separation));
        Real const bound = 32 * unit_roundoff<Real>;
        BOOST_TEST_REQUIRE((abs(dot<Real>(n, hit.after_i) - dot<Real>(n, hit.before_j)) <= bound));
        BOOST_TEST_REQUIRE((abs(dot<Real>(n, hit.after_j) - dot<Real>(n, hit.before_i)) <= bound));
        Vector3<Real> const kick = hit.after_i - hit.before_i;
        BOOST_TEST_REQUIRE((largest<Real>(kick - n * dot<Real>(n, kick)) <= bound));
        BOOST_TEST_REQUIRE((largest<Real>(hit.impulse + kick) <= bound));
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(an_exchange_undone_by_reversal_gives_the_start, Real, Reals) {
    std::mt19937_64 random(3);
    for (int k = 0; k < 5000; ++k) {
        Hit<Real> const hit(random);
        Vector3<Real> i = -hit.after_i, j = -hit.after_j;
        exchange_normal_velocities(i, j, hit.separation);
        BOOST_TEST_REQUIRE((largest<Real>(i + hit.before_i) <= 32 * unit_roundoff<Real>));
        BOOST_TEST_REQUIRE((largest<Real>(j + hit.before_j) <= 32 * unit_roundoff<Real>));
    }
}

/// However small the approach, down to the last bit, afterwards the pair recedes in the arithmetic
/// of the next prediction: or it would collide again for ever without moving.
BOOST_AUTO_TEST_CASE_TEMPLATE(pair_recedes_afterwards_to_the_last_bit, Real, Reals) {
    std::mt19937_64 random(4);
    int approached = 0;
    for (int k = 0; k < 20000; ++k) {
        Vector3<Real> const separation =
            made_up::in_cube(random, -1, 1).normalized().template cast<Real>();
        Vector3<Real> i = made_up::in_cube<Real>(random, -1, 1);
        Vector3<Real> sideways = made_up::in_cube<Real>(random, -1, 1);
        sideways -= separation * dot<Real>(separation, sideways);
        Vector3<Real> j = i + sideways;
        approached += dot<Real>(separation, j - i) < 0;
        exchange_normal_velocities(i, j, separation);
        BOOST_TEST_REQUIRE((dot<Real>(separation, j - i) >= 0));
    }
    BOOST_TEST(approached > 2000);
}

BOOST_AUTO_TEST_CASE(receding_pair_is_left_alone) {
    Vector3<double> i(0, 0, 0), j(1, 0, 0);
    Vector3<double> const impulse = exchange_normal_velocities<double>(i, j, {1, 0, 0});
    BOOST_TEST(impulse.isZero());
    BOOST_TEST(i.isZero());
}
