#include "reference/enskog.hpp"
#include "reference/free_flights.hpp"
#include "reference/kac_walk.hpp"
#include "reference/two_balls.hpp"
#include "validation/lattice_start.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>

using namespace clack::reference;
namespace tools = boost::test_tools;

BOOST_AUTO_TEST_CASE(free_flights_have_the_known_moments) {
    // computed independently, with a nested quadrature over both velocities
    BOOST_TEST(free_flights::time_moment(2) == 2.076131, tools::tolerance(1e-6));
    BOOST_TEST(free_flights::time_moment(3) == 6.683492, tools::tolerance(1e-6));
    BOOST_TEST(free_flights::length_moment(2) == 2.101218, tools::tolerance(1e-6));
    BOOST_TEST(free_flights::length_moment(3) == 6.840753, tools::tolerance(1e-6));
    BOOST_TEST(free_flights::time_density(1) == 0.360006871, tools::tolerance(1e-8));
    // The slope of the survival from a random instant is that from the last collision.
    double const h = 1e-3;
    double const slope = free_flights::time_survival(3 - h) - free_flights::time_survival(3 + h);
    BOOST_TEST(slope / (2 * h) == 0.052690641, tools::tolerance(1e-6));
    BOOST_TEST(free_flights::time_moment(1) == 1, tools::tolerance(1e-12));
    BOOST_TEST(free_flights::relative_rate(1e-5) == std::numbers::sqrt2 / 2,
               tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(enskog_has_the_known_values_and_limits) {
    Enskog const dense(0.5 * std::numbers::pi / 6); // number density 0.5, an independent program's
    BOOST_TEST(dense.collision_rate == 7.682266, tools::tolerance(1e-6));
    BOOST_TEST(dense.self_diffusion == 0.198956, tools::tolerance(3e-6));
    BOOST_TEST(dense.shear_viscosity == 0.556924, tools::tolerance(3e-6));
    BOOST_TEST(dense.bulk_viscosity == 0.426793, tools::tolerance(3e-6));
    BOOST_TEST(dense.thermal_conductivity == 2.384676, tools::tolerance(3e-6));
    Enskog const dilute(1e-9); // Boltzmann's
    BOOST_TEST(dilute.shear_viscosity == 5 * std::numbers::inv_sqrtpi / 16 * 1.016034,
               tools::tolerance(1e-7));
    BOOST_TEST(dilute.thermal_conductivity == 75 * std::numbers::inv_sqrtpi / 64 * 1.025218,
               tools::tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(tail_in_a_box_tends_to_that_of_infinitely_many_balls) {
    BOOST_TEST(long_time_tail_in_box(1000'000, 100, 0.3, 0.5, 3) == long_time_tail(1, 0.3, 0.5, 3),
               tools::tolerance(1e-3)); // which the momentum takes 1/n off
}

BOOST_AUTO_TEST_CASE(walk_keeps_energy_and_collides_at_the_exact_rate) {
    // Two balls between walls, whose rate of collisions is known exactly.
    TwoBalls const two{.side = 4};
    Eigen::Matrix3Xd velocities(3, 2);
    velocities << 1, 0, 1, 0, 2, 0; // kinetic energy 3
    KacWalk walk(velocities, walled_pair_rate(1, two.accessible_side()),
                 KacWalk::Momentum::reflected, 1);
    constexpr double time = 100'000;
    walk.advance(time);
    BOOST_TEST(walk.velocities().squaredNorm() == 6, tools::tolerance(1e-10));
    double const expected = two.collision_rate() * time;
    // 4 standard errors of the number of collisions, a little more than Poisson's
    BOOST_TEST(std::abs(static_cast<double>(walk.collisions()) - expected) <
               4 * 1.1 * std::sqrt(expected));
}

BOOST_AUTO_TEST_CASE(walk_forgets_equal_speeds_as_two_of_them_say) {
    // <v^4> / <v^2>^2 first rises by 8/35 a collision of a ball; it has bent by 1 % at 0.1.
    std::mt19937_64 random(5);
    Eigen::Matrix3Xd velocities(3, 20'000);
    for (auto velocity : velocities.colwise()) {
        for (double& component : velocity) {
            component = -6;
            for (int k = 0; k < 12; ++k) component += clack::validation::uniform(random);
        }
        velocity.normalize();
    }
    KacWalk walk(velocities, 1.0 / 20'000, KacWalk::Momentum::kept, 2);
    walk.advance(0.075);
    auto const squares = walk.velocities().colwise().squaredNorm();
    double const rise = squares.array().square().mean() - 1;
    double const met = 2 * static_cast<double>(walk.collisions()) / 20'000;
    BOOST_TEST(std::abs(met - 0.1) < 0.01);
    BOOST_TEST(std::abs(rise / met / (8.0 / 35) - 1) < 0.06); // 4 standard errors
}
