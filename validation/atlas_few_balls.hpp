#pragma once
// Scenes of the failure atlas with a few balls: such as meet in a delicate way, meet walls alone,
// or stand on a line.

#include "reference/ghost_chain.hpp"
#include "reference/one_ball.hpp"
#include "validation/atlas_problem.hpp"

#include <cmath>
#include <vector>

namespace clack::validation::atlas {

/// Which of many starts that are as good; 0 is everybody's.
using Draw = std::uint64_t;

inline double tenth(double k) { return std::pow(10.0, -k); }

inline Problem between_walls(double side, std::vector<Eigen::Vector3d> const& places,
                             std::vector<Eigen::Vector3d> const& velocities, double time) {
    Problem problem;
    problem.system.side = side;
    problem.system.count = static_cast<std::int64_t>(places.size());
    problem.start.positions.resize(3, problem.system.count);
    problem.start.velocities.resize(3, problem.system.count);
    for (std::size_t i = 0; i < places.size(); ++i) {
        problem.start.positions.col(static_cast<Eigen::Index>(i)) = places[i];
        problem.start.velocities.col(static_cast<Eigen::Index>(i)) = velocities[i];
    }
    problem.times = time > 0 ? looks(time) : std::vector<double>{};
    return problem;
}

// --- two or three balls that meet in a delicate way

inline Problem grazing(double k) {
    return between_walls(8, {{2.5, 0.75, 4}, {5.5, 0.75 + (1 - tenth(k)), 4}},
                         {{1, 0, 0}, {-0.5, 0, 0}}, 3);
}

inline Problem near_contact(double k) {
    Eigen::Vector3d const way = Eigen::Vector3d(2, 1, 2) / 3, middle(4, 4, 4);
    return between_walls(8, {middle, middle + (1 + tenth(k)) * way},
                         {{0.5, 0.25, 0.125}, {-0.5, 0.5, -0.25}}, 3);
}

inline Problem touching(double k) {
    return between_walls(8, {{3.5, 4, 4}, {4.5, 4, 4}}, {{0, 0, 0}, {-tenth(k), 0.75, 0}}, 3);
}

inline Problem triple(double k) {
    return between_walls(8, {{2, 4, 4}, {4, 4.625, 4}, {4 + tenth(k), 3.375, 4}},
                         {{1, 0, 0}, {0, 0, 0}, {0, 0, 0}}, 4);
}

/// A ball that is hit from above at the moment at which it touches the floor.
inline Problem ball_and_wall(double k) {
    return between_walls(8, {{4, 2, 4}, {1.75 + tenth(k), 1.25, 4}}, {{0, -1, 0}, {1, 0, 0}}, 3);
}

inline Problem tiny(double k) {
    double const side = std::pow(10.0, k);
    Eigen::Vector3d const from(0.1, 0.2, 0.3), to(0.9, 0.7, 0.4), meeting(0.5, 0.5, 0.5);
    Eigen::Vector3d const aside(0.25, -0.5, 0.25);
    return between_walls(side, {side * from, side * to},
                         {side * (meeting - from), side * (meeting - to) + aside}, 2);
}

/// A ball that flies through so many boxes before it meets the other: fewer than a mean free path
/// and, in a direction that is no lattice's, by no other image on the way.
inline Problem dilute(double k) {
    constexpr double side = 200;
    double const laps = std::round(std::pow(10.0, k));
    Eigen::Vector3d const way(laps * side + 8, std::round(0.618 * laps) * side + 4,
                              std::round(0.414 * laps) * side + 6);
    Eigen::Vector3d const start(2, 2, 2), aside(0.25, -0.375, 0.5);
    Eigen::Vector3d const met = start + way + aside;
    Problem problem = between_walls(
        side, {start, met - side * (met / side).array().floor().matrix()}, {way, {0, 0, 0}}, 1.05);
    problem.system.boundary = Boundary::periodic;
    return problem;
}

inline Problem far_from_zero(double k, Draw draw) {
    double const side = std::max(std::pow(10.0, k), 5.0);
    std::mt19937_64 random(2015 + draw);
    std::vector<Eigen::Vector3d> places, velocities;
    for (int n = 0; n < 8; ++n) {
        int const row = n / 2 % 2, layer = n / 4;
        Eigen::Vector3d const site(n % 2, row, layer);
        places.emplace_back(Eigen::Vector3d::Constant(side - 1) - 1.5 * site);
        velocities.emplace_back(uniform(random, -1, 1), uniform(random, -1, 1),
                                uniform(random, -1, 1));
    }
    return between_walls(side, places, velocities, 3);
}

// --- walls alone

inline Problem with_one_ball_solved(Problem problem) {
    reference::OneBall const ball(problem.system, problem.start.positions.col(0),
                                  problem.start.velocities.col(0));
    problem.exact = [ball](double time) -> Frame {
        return {ball.position(time), ball.velocity(time)};
    };
    return problem;
}

inline Problem corner(double k) {
    double const aside = tenth(k);
    return with_one_ball_solved(
        between_walls(4, {{2, 2 + aside, 2 - 2 * aside}}, {{1, 1, 1}}, 3.75));
}

inline Problem edge(double k) {
    return with_one_ball_solved(between_walls(4, {{2, 2 + tenth(k), 1.25}}, {{1, 1, 0.375}}, 3.75));
}

inline Problem one_ball(double k) {
    return with_one_ball_solved(
        between_walls(4.5, {{1, 2.25, 3.5}}, {{0.75, -1.25, 0.3125}}, 4 * std::pow(10.0, k)));
}

// --- balls on a line

inline Problem on_line(std::vector<double> const& places, std::vector<double> const& speeds,
                       double side, double time) {
    std::vector<Eigen::Vector3d> centres, velocities;
    for (std::size_t i = 0; i < places.size(); ++i) {
        centres.emplace_back(places[i], 4, 4);
        velocities.emplace_back(speeds[i], 0, 0);
    }
    Problem problem = between_walls(side, centres, velocities, time);
    problem.axes = {true, false, false};
    reference::GhostChain const chain(side, 1, places, speeds);
    problem.exact = [chain](double moment) {
        auto const x = chain.positions(moment), v = chain.velocities(moment);
        Frame frame{Eigen::Matrix3Xd::Constant(3, static_cast<Eigen::Index>(x.size()), 4),
                    Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(x.size()))};
        for (std::size_t i = 0; i < x.size(); ++i) {
            frame.places(0, static_cast<Eigen::Index>(i)) = x[i];
            frame.velocities(0, static_cast<Eigen::Index>(i)) = v[i];
        }
        return frame;
    };
    return problem;
}

inline Problem cradle(std::size_t count, double gap) {
    std::vector<double> places{1}, speeds{1};
    for (std::size_t i = 1; i < count; ++i) {
        places.push_back(i == 1 ? 3.0 : places.back() + (1 + gap));
        speeds.push_back(0);
    }
    // The last ball comes back from the wall, and the first one after it.
    return on_line(places, speeds, places.back() + 3.25, 7.3);
}

inline Problem chain(double k, Draw draw) {
    std::mt19937_64 random(3 + draw);
    std::vector<double> places, speeds;
    for (int i = 0; i < 10; ++i) {
        places.push_back(1 + 2 * i + std::round(1024 * uniform(random, -0.25, 0.25)) / 1024);
        speeds.push_back(std::round(1024 * uniform(random, -1, 1)) / 1024);
    }
    return on_line(places, speeds, 20, std::pow(10.0, k)); // some ten collisions a unit of time
}

} // namespace clack::validation::atlas
