#pragma once
// The scenes of the failure atlas: each has a parameter that makes it harder.

#include "validation/atlas_few_balls.hpp"
#include "validation/harness/experiment.hpp"

#include <numbers>
#include <string>

namespace clack::validation::atlas {

/// A row of the atlas.
struct Scene {
    std::string name;
    std::string parameter;      // what grows with k
    std::vector<double> levels; // of k, from easy to hard
    std::function<Problem(double k)> make;
};

/// Balls on a cubic lattice with random velocities, or at rest.
inline Problem lattice_gas(std::int64_t across, double spacing, double speed, double time,
                           Draw draw) {
    std::mt19937_64 random(2015 + draw);
    std::vector<Eigen::Vector3d> places, velocities;
    for (std::int64_t k = 0; k < across * across * across; ++k) {
        std::int64_t const x = k % across, y = k / across % across, z = k / across / across;
        Eigen::Vector3d const site(static_cast<double>(x), static_cast<double>(y),
                                   static_cast<double>(z));
        places.emplace_back(Eigen::Vector3d::Constant(spacing / 2) + spacing * site);
        Eigen::Vector3d velocity;
        for (int d = 0; d < 3; ++d) velocity[d] = speed * uniform(random, -1, 1);
        velocities.push_back(velocity);
    }
    return between_walls(spacing * static_cast<double>(across), places, velocities, time);
}

/// All speeds are equal and all balls stand in line, but for 10^-k.
inline Problem equal_speeds(double k, Draw draw) {
    Problem problem = lattice_gas(3, 1.5, 1, 1.4, draw);
    std::mt19937_64 random(2016 + draw);
    for (Eigen::Index i = 0; i < problem.start.positions.cols(); ++i) {
        for (int d = 0; d < 3; ++d) {
            problem.start.positions(d, i) += 0.2 * tenth(k) * uniform(random, -1, 1);
            problem.start.velocities(d, i) = problem.start.velocities(d, i) < 0 ? -1 : 1;
        }
    }
    return problem;
}

inline Problem one_fast(double k, Draw draw) {
    double const factor = std::pow(10.0, k);
    Problem problem = lattice_gas(3, 2, 1, 12 / factor, draw);
    problem.start.velocities.col(13) = factor * Eigen::Vector3d(0.875, 0.3, 0.4);
    return problem;
}

inline Problem all_but_one_at_rest(double k) {
    Problem problem = lattice_gas(static_cast<std::int64_t>(std::lround(k)), 1.75, 0, 8, 0);
    problem.start.velocities.col(0) = Eigen::Vector3d(0.9, 0.4, 0.5);
    return problem;
}

/// An fcc crystal whose balls have 10^-k diameters of room between them: pressure 10^k kT a volume
/// of a ball. A few collisions a ball.
inline Problem near_close_packing(double k, Draw draw) {
    double const room = tenth(k);
    Problem problem;
    problem.system = {
        .boundary = Boundary::periodic, .side = 3 * std::numbers::sqrt2 * (1 + room), .count = 108};
    problem.start = lattice_start(problem.system, 2015 + draw);
    problem.times = looks(2 * room);
    return problem;
}

inline Problem clock_far_on(double k, Draw draw) {
    Problem problem = lattice_gas(2, 1.75, 1, 0, draw);
    for (int look = 1; look <= 8; ++look) problem.times.push_back(0.25 * look); // exact so late too
    problem.clock = std::exp2(std::round(k * std::log2(10.0)));
    return problem;
}

inline Problem there_and_back(double k, Draw draw) {
    Problem problem = lattice_gas(3, 1.5, 1, k, draw);
    problem.turns_round = true;
    return problem;
}

inline Problem two_in_cube(double k) {
    return between_walls(3, {{0.75, 1, 1.25}, {2.25, 2, 1.75}},
                         {{1, 0.25, -0.5}, {-0.75, 0.5, 0.25}}, k);
}

inline Problem two_in_periodic(double k) {
    Problem problem = between_walls(3, {{0.75, 1, 1.25}, {2.25, 2, 1.75}},
                                    {{1, 0.25, -0.5}, {-1, -0.25, 0.5}}, k);
    problem.system.boundary = Boundary::periodic;
    return problem;
}

/// So many collisions of balls, 10^k, that only the invariants are left to ask for.
inline Problem long_run(double k, Draw draw) {
    constexpr double collisions_per_time = 6.7; // about: for methods that count time
    Problem problem = lattice_gas(2, 1.6, 1, 0, draw);
    problem.times = looks(std::pow(10.0, k) / collisions_per_time, 16);
    problem.has_reference = false;
    problem.long_collisions = std::round(std::pow(10.0, k));
    return problem;
}

inline Problem very_long_run(double k, Draw draw) {
    Problem problem = long_run(k, draw);
    problem.fast_alone = true;
    return problem;
}

inline std::vector<double> levels(double from, double to, double step) {
    std::vector<double> all;
    for (double k = from; k <= to + step / 2; k += step) all.push_back(k);
    return all;
}

/// All rows. Where chance has a part in a start, `draw` says which is taken.
inline std::vector<Scene> scenes(Profile const profile, Draw const draw = 0) {
    bool const full = profile == Profile::full;
    auto const drawn = [draw](Problem (*make)(double, Draw)) {
        return [=](double k) { return make(k, draw); };
    };
    return {
        {"grazing hit", "impact parameter 1 - 10^-k", levels(1, 15, 2), grazing},
        {"near contact", "gap 10^-k", levels(1, 17, 2), near_contact},
        {"touching", "normal speed 10^-k", levels(0, 16, 2), touching},
        {"symmetric triple", "delay 10^-k", levels(1, 17, 2), triple},
        {"ball and wall at once", "delay 10^-k", levels(1, 17, 2), ball_and_wall},
        {"lattice of equal speeds", "disorder 10^-k", levels(1, 17, 4), drawn(equal_speeds)},
        {"touching cradle", "10^k balls", levels(0.5, 2, 0.5),
         [](double k) { return cradle(static_cast<std::size_t>(std::pow(10.0, k)), 0); }},
        {"cradle of 10 balls", "gaps 10^-k", levels(1, 17, 2),
         [](double k) { return cradle(10, tenth(k)); }},
        {"corner", "delays 10^-k", levels(1, 17, 2), corner},
        {"edge", "delay 10^-k", levels(1, 17, 2), edge},
        {"one fast ball", "speed 10^k", levels(0, 8, 1), drawn(one_fast)},
        {"tiny balls", "side 10^k diameters", levels(1, 7, 1), tiny},
        {"near close packing", "pressure 10^k", levels(1, 6, full ? 1 : 2.5),
         drawn(near_close_packing)},
        {"dilute", "free path 10^k boxes", levels(0, 4, 1), dilute},
        {"long run", "10^k collisions", levels(3, full ? 7.5 : 5, full ? 1.5 : 1), drawn(long_run)},
        {"very long run", "10^k collisions", levels(full ? 8 : 6, full ? 9 : 6, 1),
         drawn(very_long_run)},
        {"late clock", "clock 10^k", levels(0, 12, 2), drawn(clock_far_on)},
        // Longer, and rounding would decide whether a grazing pair meets, in one start of a
        // hundred.
        {"time reversal", "time k each way", levels(3, 12, 3), drawn(there_and_back)},
        {"all at rest but one", "k^3 balls", levels(2, 5, 1), all_but_one_at_rest},
        {"one ball", "path 4 10^k", levels(0, 4, 1), one_ball},
        {"two balls between walls", "time k", levels(2, 14, 4), two_in_cube},
        {"two periodic balls", "time k", levels(4, 16, 4), two_in_periodic},
        {"balls on a line", "time 10^k", levels(1, full ? 3.5 : 3, 0.5), drawn(chain)},
        {"far from zero", "side 10^k", levels(1, 12, 1), drawn(far_from_zero)},
    };
}

} // namespace clack::validation::atlas
