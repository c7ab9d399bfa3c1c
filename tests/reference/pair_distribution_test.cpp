#include "reference/pair_distribution.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

using namespace clack::reference;

BOOST_AUTO_TEST_CASE(closure_has_its_known_contact_value_and_compressibility) {
    for (double const eta : {0.01, 0.2, 0.45}) {
        PercusYevick const closure(eta, 3);
        double const contact = (1 + eta / 2) / ((1 - eta) * (1 - eta));
        BOOST_TEST(std::abs(closure.radial_distribution(1) / contact - 1) < 2e-5);
        double const compressibility = std::pow(1 - eta, 4) / std::pow(1 + 2 * eta, 2);
        BOOST_TEST(std::abs(closure.structure_factor(1e-6) / compressibility - 1) < 1e-8);
        BOOST_TEST(closure.radial_distribution(0.99) == 0);
    }
}

BOOST_AUTO_TEST_CASE(dilute_closure_is_the_overlap_of_two_spheres) {
    // g = 1 + rho (4 pi / 3) (1 - 3 r / 4 + r^3 / 16) up to r = 2, 1 beyond, to the first order
    double const eta = 1e-4, rho = eta * 6 / std::numbers::pi;
    PercusYevick const closure(eta, 3);
    for (double const r : {1.0, 1.3, 1.7, 2.0, 2.5}) {
        double const overlap =
            r < 2 ? 4 * std::numbers::pi / 3 * (1 - 0.75 * r + r * r * r / 16) : 0;
        BOOST_TEST(std::abs(closure.radial_distribution(r) - 1 - rho * overlap) < 1e-7);
    }
}

/// Wertheim's closed form for 1 < r < 2, at packing fraction 0.4: r g(r) = sum of a_i exp(t_i
/// (r - 1)) over the three roots t_i of S(t) = (1 - eta)^2 t^3 + 6 eta (1 - eta) t^2 + 18 eta^2 t -
/// 12 eta (1 + 2 eta), a_i = t_i L(t_i) / S'(t_i).
BOOST_AUTO_TEST_CASE(closure_is_wertheims_between_one_and_two_diameters) {
    double const eta = 0.4;
    PercusYevick const closure(eta, 3);
    auto const s = [&](std::complex<double> t) {
        return (1 - eta) * (1 - eta) * t * t * t + 6 * eta * (1 - eta) * t * t +
               18 * eta * eta * t - 12 * eta * (1 + 2 * eta);
    };
    auto const slope = [&](std::complex<double> t) {
        return 3 * (1 - eta) * (1 - eta) * t * t + 12 * eta * (1 - eta) * t + 18 * eta * eta;
    };
    for (double const r : {1.0, 1.2, 1.6, 1.95}) {
        std::complex<double> sum = 0;
        for (std::complex<double> t : {std::complex{1.0, 0.0}, {-4.0, 5.0}, {-4.0, -5.0}}) {
            for (int k = 0; k < 50; ++k) t -= s(t) / slope(t);
            sum += t * ((1 + eta / 2) * t + (1 + 2 * eta)) / slope(t) * std::exp(t * (r - 1));
        }
        BOOST_TEST(std::abs(closure.radial_distribution(r) - sum.real() / r) < 2e-5);
    }
}

BOOST_AUTO_TEST_CASE(mended_closure_has_the_contact_value_it_is_given) {
    double const eta = 0.45;
    double const contact = (1 - eta / 2) / std::pow(1 - eta, 3); // Carnahan and Starling's
    VerletWeis const mended(eta, contact, 4);
    BOOST_TEST(std::abs(mended.radial_distribution(1) - contact) < 1e-12);
    // The amplitude that Verlet and Weis fitted, 0.75 eta^2 (1 - 0.7117 eta - 0.114 eta^2) /
    // (1 - eta)^4, is this difference to 0.6 %.
    double const w = eta - eta * eta / 16;
    double const fitted = 0.75 * w * w * (1 - 0.7117 * w - 0.114 * w * w) / std::pow(1 - w, 4);
    double const width = std::cbrt(w / eta);
    double const missing = contact - PercusYevick(w, 4).radial_distribution(1 / width);
    BOOST_TEST(std::abs(missing / fitted - 1) < 0.006);
    BOOST_TEST(std::abs(mended.radial_distribution(3.9) - 1) < 0.05);
}

BOOST_AUTO_TEST_CASE(what_is_no_fluid_is_refused) {
    BOOST_CHECK_THROW(PercusYevick(0, 2), std::invalid_argument);
    BOOST_CHECK_THROW(PercusYevick(0.6, 2), std::invalid_argument);
    BOOST_CHECK_THROW(PercusYevick(0.3, 2).radial_distribution(2.1), std::invalid_argument);
}
