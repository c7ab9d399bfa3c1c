#include "reference/frame_stepping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace clack::reference {

namespace {

constexpr std::int64_t nobody = -1;
constexpr std::int64_t cells_min = 3; // with fewer, a cell would be its own neighbour twice

/// One where the cube is too narrow for more.
std::int64_t cells_along(System const& system) {
    auto const fit = static_cast<std::int64_t>(std::floor(system.side / system.diameter));
    auto const useful =
        static_cast<std::int64_t>(std::ceil(std::cbrt(static_cast<double>(system.count))));
    return fit < cells_min ? 1 : std::min(fit, std::max(useful, cells_min));
}

} // namespace

FrameStepping::FrameStepping(System const& system, Start start, double const step)
    : system_(system), balls_(std::move(start)), step_(step), cells_(cells_along(system)),
      next_in_cell_(static_cast<std::size_t>(system.count), nobody) {
    if (!(step > 0)) throw std::invalid_argument(fmt::format("step = {}: must be positive", step));
    first_in_cell_.resize(static_cast<std::size_t>(cells_ * cells_ * cells_));
}

void FrameStepping::advance(std::int64_t const steps) {
    for (std::int64_t k = 0; k < steps; ++k) {
        move();
        sort_into_cells();
        for (std::int64_t ball = 0; ball < system_.count; ++ball) meet_neighbours(ball);
        ++steps_;
    }
}

void FrameStepping::move() {
    balls_.positions += balls_.velocities * step_;
    double const low = system_.boundary == Boundary::walls ? system_.diameter / 2 : 0;
    double const high = system_.side - low;
    for (Eigen::Index k = 0; k < balls_.positions.size(); ++k) {
        double& x = balls_.positions(k);
        if (x >= low && x <= high) continue;
        if (system_.boundary == Boundary::periodic) {
            x -= system_.side * std::floor(x / system_.side);
            continue;
        }
        double& v = balls_.velocities(k);
        double const wall = x < low ? low : high;
        x = 2 * wall - x;
        if ((wall - x) * v < 0) continue; // a pair pushed it there, and it comes back by itself
        tallies_.wall_impulse += 2 * system_.mass * std::abs(v);
        ++tallies_.wall_collisions;
        v = -v;
    }
}

std::int64_t FrameStepping::cell_of(Eigen::Vector3d const& place) const {
    std::int64_t cell = 0;
    for (int d = 0; d < 3; ++d) {
        auto const along =
            static_cast<std::int64_t>(place[d] / system_.side * static_cast<double>(cells_));
        cell = cell * cells_ + std::clamp<std::int64_t>(along, 0, cells_ - 1);
    }
    return cell;
}

void FrameStepping::sort_into_cells() {
    std::fill(first_in_cell_.begin(), first_in_cell_.end(), nobody);
    for (std::int64_t ball = system_.count; ball-- > 0;) {
        auto& first = first_in_cell_[static_cast<std::size_t>(cell_of(balls_.positions.col(ball)))];
        next_in_cell_[static_cast<std::size_t>(ball)] = first;
        first = ball;
    }
}

/// Each pair once: with those of a higher number.
void FrameStepping::meet_neighbours(std::int64_t const ball) {
    std::int64_t const cell = cell_of(balls_.positions.col(ball));
    std::int64_t const at[]{cell / (cells_ * cells_), cell / cells_ % cells_, cell % cells_};
    bool const periodic = system_.boundary == Boundary::periodic;
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
        std::int64_t const towards[]{neighbour / 9 - 1, neighbour / 3 % 3 - 1, neighbour % 3 - 1};
        std::int64_t other_cell = 0;
        bool inside = true;
        for (int d = 0; d < 3; ++d) {
            std::int64_t along = at[d] + towards[d];
            if (cells_ == 1 && towards[d] != 0) inside = false;
            if (periodic) along = (along + cells_) % cells_;
            inside = inside && along >= 0 && along < cells_;
            other_cell = other_cell * cells_ + along;
        }
        if (!inside) continue;
        for (std::int64_t other = first_in_cell_[static_cast<std::size_t>(other_cell)];
             other != nobody; other = next_in_cell_[static_cast<std::size_t>(other)])
            if (other > ball) meet(ball, other);
    }
}

Eigen::Vector3d FrameStepping::separation(std::int64_t const i, std::int64_t const j) const {
    Eigen::Vector3d r = balls_.positions.col(j) - balls_.positions.col(i);
    if (system_.boundary == Boundary::periodic)
        for (int d = 0; d < 3; ++d) r[d] -= system_.side * std::nearbyint(r[d] / system_.side);
    return r;
}

void FrameStepping::meet(std::int64_t const i, std::int64_t const j) {
    Eigen::Vector3d const r = separation(i, j);
    double const distance2 = r.squaredNorm();
    if (!(distance2 < system_.diameter * system_.diameter) || distance2 == 0) return;
    double const distance = std::sqrt(distance2);
    double const depth = system_.diameter - distance;
    tallies_.deepest_overlap = std::max(tallies_.deepest_overlap, depth / system_.diameter);

    double const approach = r.dot(balls_.velocities.col(j) - balls_.velocities.col(i));
    if (approach < 0) {
        Eigen::Vector3d const kick = r * (approach / distance2);
        balls_.velocities.col(i) += kick;
        balls_.velocities.col(j) -= kick;
        // The impulse acts along the line of centres; of balls that had collided in time it would
        // have acted at a distance of one diameter.
        tallies_.virial -= system_.mass * approach / distance * system_.diameter;
        ++tallies_.ball_collisions;
        pairs_.push_back({i, j});
    }
    Eigen::Vector3d const push = r * (depth / (2 * distance));
    balls_.positions.col(i) -= push;
    balls_.positions.col(j) += push;
}

} // namespace clack::reference
