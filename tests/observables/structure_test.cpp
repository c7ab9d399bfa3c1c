// g(r), S(k), the profile at walls and the bond order, on arrangements whose answer is known.

#include "observables/bond_order.hpp"
#include "observables/density_profile.hpp"
#include "observables/radial_distribution.hpp"
#include "observables/structure_factor.hpp"
#include "scenes/lattice.hpp"

#include <boost/test/unit_test.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

using namespace clack;

namespace {

/// Balls that do not see each other, uniform in the room of the centres.
Snapshot thrown_at_random(System const& system, std::uint64_t const seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0, system.accessible_side());
    Snapshot snapshot;
    snapshot.positions.resize(3, system.count);
    for (double& place : snapshot.positions.reshaped())
        place = uniform(random) + (system.side - system.accessible_side()) / 2;
    return snapshot;
}

System periodic(double const side, std::int64_t const count, double const diameter) {
    return {Boundary::periodic, side, count, diameter, 1};
}

} // namespace

BOOST_AUTO_TEST_CASE(points_at_random_have_a_flat_g_of_1_less_1_over_n) {
    System const system = periodic(5, 40, 1e-3);
    RadialDistribution g(system, 2.5, 10);
    constexpr int snapshots = 2000;
    for (int k = 0; k < snapshots; ++k)
        g.add(thrown_at_random(system, static_cast<std::uint64_t>(k)));
    for (std::size_t k = 0; k < 10; ++k) {
        double const r = g.distances()[k], half = 2.499 / 20;
        double const shell =
            4 * std::numbers::pi / 3 * (std::pow(r + half, 3) - std::pow(r - half, 3));
        double const pairs = snapshots * 40 * 39 / 2 * shell / 125;
        // 4.5 standard errors: one of ten bins beyond by chance in 1e-4 of such runs
        BOOST_TEST(std::abs(g.values()[k] / (1 - 1.0 / 40) - 1) < 4.5 / std::sqrt(pairs));
    }
}

BOOST_AUTO_TEST_CASE(g_of_a_lattice_counts_its_neighbours) {
    System const system = periodic(6, 4 * 64, 1); // cells of 1.5, neighbours at 1.5 / sqrt(2)
    RadialDistribution g(system, 3, 200);
    Snapshot snapshot;
    snapshot.positions = place_on_fcc(system);
    g.add(snapshot);
    double neighbours = 0, second = 0;
    for (std::size_t k = 0; k < 200; ++k) {
        double const r = g.distances()[k], half = 0.005;
        double const shell =
            4 * std::numbers::pi / 3 * (std::pow(r + half, 3) - std::pow(r - half, 3));
        double const balls = g.values()[k] * system.number_density() * shell;
        if (std::abs(r - 1.5 / std::numbers::sqrt2) < 0.1) neighbours += balls;
        if (std::abs(r - 1.5) < 0.1) second += balls;
    }
    BOOST_TEST(std::abs(neighbours - 12) < 1e-9);
    BOOST_TEST(std::abs(second - 6) < 1e-9);
    BOOST_CHECK_THROW(RadialDistribution(system, 3.1, 10), std::invalid_argument);
    BOOST_CHECK_THROW(RadialDistribution({Boundary::walls, 6, 10}, 2, 10), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(polynomials_are_extrapolated_exactly) {
    std::vector<double> places, values;
    for (double x = 1.05; x < 1.2; x += 0.01) {
        places.push_back(x);
        values.push_back(3 - 2 * x + 5 * x * x * x);
    }
    BOOST_TEST(std::abs(extrapolated(places, values, 1, 3) - 6) < 1e-9);
    BOOST_TEST(std::abs(extrapolated(places, values, 1, 2) - 6) > 1e-4); // too low a degree
    BOOST_CHECK_THROW(extrapolated({1, 2}, {1, 2}, 0, 2), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(points_at_random_have_waves_of_1_and_a_lattice_only_its_own) {
    System const system = periodic(7, 50, 0.1);
    StructureFactor waves(system, 4);
    constexpr int snapshots = 4000;
    for (int k = 0; k < snapshots; ++k)
        waves.add(thrown_at_random(system, static_cast<std::uint64_t>(k)));
    BOOST_REQUIRE(waves.values().size() == 4);
    BOOST_TEST(std::abs(waves.wave_numbers()[1] - 2 * std::numbers::pi / 7 * std::sqrt(2.0)) <
               1e-12);
    double const vectors[] = {3, 6, 4, 3}; // |sum|^2 / N is exponential: its error is its mean
    for (std::size_t k = 0; k < 4; ++k)
        BOOST_TEST(std::abs(waves.values()[k] - 1) < 4 / std::sqrt(snapshots * vectors[k]));

    System const crystal = periodic(4, 8, 1); // simple cubic, two cells a side
    StructureFactor bragg(crystal, 4);
    Snapshot snapshot;
    snapshot.positions = place_on_grid(crystal);
    bragg.add(snapshot);
    for (std::size_t k = 0; k < 3; ++k) BOOST_TEST(bragg.values()[k] < 1e-24);
    BOOST_TEST(std::abs(bragg.values()[3] - 8) < 1e-12); // all in phase: N
    BOOST_CHECK_THROW(StructureFactor({Boundary::walls, 4, 8}, 4), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(points_at_random_have_a_flat_profile_at_walls) {
    System const system{Boundary::walls, 6, 100, 1, 1};
    DensityProfile face(system, 3, 5), middle_of_face(system, 3, 5, 1.5);
    double in_the_middle = 0;
    constexpr int snapshots = 2000;
    for (int k = 0; k < snapshots; ++k) {
        Snapshot const snapshot = thrown_at_random(system, static_cast<std::uint64_t>(k));
        face.add(snapshot);
        middle_of_face.add(snapshot);
        in_the_middle += density_in_the_middle(system, snapshot, 1) / snapshots;
    }
    double const density = 100.0 / 125;
    for (std::size_t k = 0; k < 5; ++k) {
        double const balls = snapshots * density * 6 * 0.5; // a unit of area
        BOOST_TEST(std::abs(face.values()[k] / density - 1) < 4.5 / std::sqrt(25 * balls));
        BOOST_TEST(std::abs(middle_of_face.values()[k] / density - 1) < 4.5 / std::sqrt(4 * balls));
    }
    // the weights' squares add up to 0.42 of what the weights do
    BOOST_TEST(std::abs(in_the_middle / density - 1) <
               4.5 * std::sqrt(0.42 / (snapshots * density)));
    BOOST_TEST(face.distances().front() == 0.75);
    BOOST_CHECK_THROW(DensityProfile(system, 3.1, 5), std::invalid_argument);
    BOOST_CHECK_THROW(DensityProfile(system, 3, 5, 2.5), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(bond_order_knows_lattices_from_disorder_however_they_are_turned) {
    System const system = periodic(6, 4 * 64, 1);
    Snapshot snapshot;
    snapshot.positions = place_on_fcc(system);
    BOOST_TEST(std::abs(bond_order(system, snapshot, 1.3) - 0.57452) < 1e-5);
    BOOST_TEST(bond_order(system, snapshot, 0.9) == 0);
    snapshot = thrown_at_random(system, 1);
    BOOST_TEST(bond_order(system, snapshot, 1.3) < 0.1);

    System const cube{Boundary::walls, 6, 27, 1, 1}; // simple cubic
    snapshot.positions = place_on_grid(cube).array() - 3;
    auto const turn = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized());
    snapshot.positions = (turn.toRotationMatrix() * snapshot.positions).array() + 6;
    BOOST_TEST(std::abs(bond_order({Boundary::walls, 12, 27}, snapshot, 2.5) - 0.35355) < 1e-5);
}
