#include "reference/soft_balls.hpp"

#include <boost/test/unit_test.hpp>

using namespace clack::reference;

BOOST_AUTO_TEST_CASE(a_head_on_contact_lasts_half_a_period) {
    // Two balls of mass 1 push each other apart: their overlap x obeys x'' = -2k x.
    double const k = 300, dt = 1e-5;
    double overlap = 0, speed = 1, time = 0;
    do {
        speed -= k * overlap * dt;
        overlap += speed * dt;
        speed -= k * overlap * dt;
        time += dt;
    } while (overlap > 0);
    BOOST_TEST(std::abs(time - contact_duration(k)) < 2 * dt);
}

BOOST_AUTO_TEST_CASE(a_stepped_contact_is_shorter_by_the_leading_term) {
    for (double const n : {8.0, 20.0, 100.0}) {
        // Leapfrog swings with sin(w' dt / 2) = w dt / 2.
        double const half = std::numbers::pi / (2 * n);
        double const exact = half / std::asin(half);
        double const found = stepped_contact_duration(50, n) / contact_duration(50);
        BOOST_TEST(std::abs(found - exact) < 3 * std::pow(half, 4)); // the next term
    }
}

BOOST_AUTO_TEST_CASE(barker_henderson_diameter_is_its_integral) {
    double const k = 500, kt = 0.8;
    double sum = 0;
    int const steps = 20'000;
    for (int i = 0; i < steps; ++i) {
        double const r = (i + 0.5) / steps * 1.3, overlap = 1.3 - r;
        sum += (1 - std::exp(-k * overlap * overlap / (2 * kt))) * 1.3 / steps;
    }
    BOOST_TEST(std::abs(barker_henderson_diameter(1.3, k, kt) - sum) < 1e-8);
}
