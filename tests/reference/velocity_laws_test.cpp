#include "reference/velocity_laws.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace clack;
using namespace clack::reference;

namespace {

System system_of(Boundary const boundary, std::int64_t const count, double const mass = 1.5) {
    return {.boundary = boundary, .side = 9, .count = count, .mass = mass};
}

constexpr double energy = 7.25;

template <class F> double integral(F const& f, double const low, double const high) {
    return boost::math::quadrature::tanh_sinh<double>().integrate(f, low, high);
}

struct Case {
    Boundary boundary;
    std::int64_t count;
};
// Two balls between walls and three in a periodic cube are the fewest; their densities end upright.
constexpr Case cases[] = {{Boundary::walls, 2},    {Boundary::walls, 8},
                          {Boundary::walls, 128},  {Boundary::periodic, 3},
                          {Boundary::periodic, 8}, {Boundary::periodic, 128}};

} // namespace

BOOST_AUTO_TEST_CASE(probability_is_the_integral_of_the_density) {
    for (auto const& [boundary, count] : cases) {
        VelocityLaw const law(system_of(boundary, count), energy);
        double const top = law.top_speed();
        for (double const v : {0.1 * top, 0.4 * top, 0.9 * top, top}) {
            double const speeds = integral([&](double u) { return law.speed_density(u); }, 0.0, v);
            double const components =
                integral([&](double u) { return law.component_density(u); }, -top, v);
            BOOST_TEST(std::abs(speeds - law.speed_probability(v)) < 1e-9);
            BOOST_TEST(std::abs(components - law.component_probability(v)) < 1e-9);
        }
        BOOST_TEST(law.speed_probability(1.1 * top) == 1);
        BOOST_TEST(law.speed_density(1.1 * top) == 0);
        BOOST_TEST(law.component_probability(-1.1 * top) == 0);
        BOOST_TEST(law.component_density(-1.1 * top) == 0);
    }
}

BOOST_AUTO_TEST_CASE(mean_square_speed_shares_the_energy_evenly) {
    for (auto const& [boundary, count] : cases) {
        System const system = system_of(boundary, count);
        VelocityLaw const law(system, energy);
        double const shared = 2 * energy / (system.mass * static_cast<double>(count));
        double const second =
            integral([&](double v) { return v * v * law.speed_density(v); }, 0.0, law.top_speed());
        double const square_component =
            integral([&](double v) { return v * v * law.component_density(v); }, -law.top_speed(),
                     law.top_speed());
        BOOST_TEST(std::abs(law.mean_square_speed() / shared - 1) < 1e-14);
        BOOST_TEST(std::abs(second / shared - 1) < 1e-9);
        BOOST_TEST(std::abs(3 * square_component / shared - 1) < 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(fourth_moment_is_the_densitys) {
    for (auto const& [boundary, count] : cases) {
        VelocityLaw const law(system_of(boundary, count), energy);
        double const fourth = integral(
            [&](double v) { return v * v * v * v * law.speed_density(v); }, 0.0, law.top_speed());
        double const ratio = fourth / std::pow(law.mean_square_speed(), 2);
        BOOST_TEST(std::abs(ratio / law.fourth_moment_ratio() - 1) < 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(two_balls_between_walls_have_the_law_of_a_point_on_a_six_sphere) {
    // f(v) is proportional to v^2 (1 - v^2/top^2)^(1/2): Beta(3/2, 3/2), whose median is one half.
    VelocityLaw const law(system_of(Boundary::walls, 2), energy);
    BOOST_TEST(std::abs(law.speed_probability(law.top_speed() * std::sqrt(0.5)) - 0.5) < 1e-14);
    double const v = 0.3 * law.top_speed();
    double const ratio = law.speed_density(2 * v) / law.speed_density(v);
    BOOST_TEST(std::abs(ratio - 4 * std::sqrt((1 - 0.36) / (1 - 0.09))) < 1e-13);
}

BOOST_AUTO_TEST_CASE(no_ball_of_a_periodic_cube_has_all_the_energy) {
    // Momentum 0: the others must move against it, best all alike.
    System const system = system_of(Boundary::periodic, 3, 1);
    double const top = VelocityLaw(system, energy).top_speed();
    BOOST_TEST(std::abs(top * top / 2 + 2 * (top / 2) * (top / 2) / 2 - energy) < 1e-13);
}

BOOST_AUTO_TEST_CASE(quantile_inverts_probability) {
    VelocityLaw const law(system_of(Boundary::walls, 8), energy);
    for (double const p : {0.001, 0.25, 0.5, 0.99})
        BOOST_TEST(std::abs(law.speed_probability(law.speed_quantile(p)) - p) < 1e-10);
    VelocityLaw const of_many(system_of(Boundary::walls, 1000), energy);
    for (int k = 1; k < 32; ++k)
        BOOST_TEST(std::abs(of_many.speed_probability(of_many.speed_quantile(k / 32.0)) -
                            k / 32.0) < 1e-10);
}

BOOST_AUTO_TEST_CASE(many_balls_obey_maxwell_and_boltzmann) {
    std::int64_t const count = 10'000'000;
    double const temperature = 2;
    System const system = system_of(Boundary::walls, count);
    VelocityLaw const law(system, 1.5 * static_cast<double>(count) * temperature);
    MaxwellBoltzmann const limit(temperature, system.mass);
    for (double const v : {0.2, 1.0, 2.5, 4.0}) {
        BOOST_TEST(std::abs(law.speed_density(v) / limit.speed_density(v) - 1) < 1e-5);
        BOOST_TEST(std::abs(law.speed_probability(v) - limit.speed_probability(v)) < 1e-6);
        BOOST_TEST(std::abs(law.component_density(-v) / limit.component_density(-v) - 1) < 1e-5);
        BOOST_TEST(std::abs(law.component_probability(v) - limit.component_probability(v)) < 1e-6);
    }
    BOOST_TEST(std::abs(law.fourth_moment_ratio() - MaxwellBoltzmann::fourth_moment_ratio) < 1e-6);
}

BOOST_AUTO_TEST_CASE(maxwell_boltzmann_has_its_known_means) {
    MaxwellBoltzmann const law(1, 1);
    double const mean = integral([&](double v) { return v * law.speed_density(v); }, 0.0, 40.0);
    BOOST_TEST(std::abs(mean - 1.595769) < 1e-6); // sqrt(8 / pi)
    BOOST_TEST(std::abs(law.speed_probability(40) - 1) < 1e-15);
    for (double const v : {0.5, 1.5})
        BOOST_TEST(std::abs(integral([&](double u) { return law.speed_density(u); }, 0.0, v) -
                            law.speed_probability(v)) < 1e-9);
}

BOOST_AUTO_TEST_CASE(laws_are_refused_where_they_do_not_hold) {
    BOOST_CHECK_THROW(VelocityLaw(system_of(Boundary::walls, 1), energy), std::invalid_argument);
    BOOST_CHECK_THROW(VelocityLaw(system_of(Boundary::periodic, 2), energy), std::invalid_argument);
    BOOST_CHECK_THROW(VelocityLaw(system_of(Boundary::walls, 8), 0), std::invalid_argument);
    BOOST_CHECK_THROW(MaxwellBoltzmann(0, 1), std::invalid_argument);
    BOOST_CHECK_THROW(MaxwellBoltzmann(1, -1), std::invalid_argument);
}
