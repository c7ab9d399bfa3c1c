#include "reference/ghost_chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace clack::reference {

GhostChain::GhostChain(double const side, double const diameter,
                       std::vector<double> const& positions, std::vector<double> const& velocities)
    : diameter_(diameter) {
    if (positions.size() != velocities.size() || positions.empty()) {
        throw std::invalid_argument(fmt::format("{} positions, {} velocities: want one of each a "
                                                "ball, and a ball",
                                                positions.size(), velocities.size()));
    }
    double const free = side - diameter * static_cast<double>(positions.size());
    double left = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        double const place = positions[i] - (static_cast<double>(i) + 0.5) * diameter;
        if (place < left) {
            throw std::invalid_argument(
                fmt::format("positions[{}] = {}: overlaps its left neighbour", i, positions[i]));
        }
        ghosts_.emplace_back(free, place, velocities[i]);
        left = place;
    }
}

std::vector<GhostChain::Ghost> GhostChain::in_order(double const time) const {
    std::vector<Ghost> ghosts;
    for (TriangleWave const& ghost : ghosts_)
        ghosts.push_back({ghost.position(time), ghost.velocity(time)});
    std::sort(ghosts.begin(), ghosts.end(),
              [](Ghost const& a, Ghost const& b) { return a.place < b.place; });
    return ghosts;
}

std::vector<double> GhostChain::positions(double const time) const {
    std::vector<double> centres;
    for (Ghost const& ghost : in_order(time))
        centres.push_back(ghost.place + (static_cast<double>(centres.size()) + 0.5) * diameter_);
    return centres;
}

std::vector<double> GhostChain::velocities(double const time) const {
    std::vector<double> velocities;
    for (Ghost const& ghost : in_order(time)) velocities.push_back(ghost.velocity);
    return velocities;
}

std::int64_t GhostChain::ball_collisions(double const time) const {
    // Two ghosts meet where their unfolded places are equal, or opposite, modulo the period.
    std::int64_t passed = 0;
    for (std::size_t i = 0; i < ghosts_.size(); ++i) {
        for (std::size_t j = i + 1; j < ghosts_.size(); ++j) {
            TriangleWave const &a = ghosts_[i], &b = ghosts_[j];
            long double const period = 2 * a.length_;
            passed += marks_passed(b.start_ - a.start_, (b.velocity_ - a.velocity_) * time, period);
            passed += marks_passed(b.start_ + a.start_, (b.velocity_ + a.velocity_) * time, period);
        }
    }
    return passed;
}

std::int64_t GhostChain::wall_collisions(double const time) const {
    std::int64_t hits = 0;
    for (TriangleWave const& ghost : ghosts_) hits += ghost.hits(time);
    return hits;
}

} // namespace clack::reference
