#include "view/confinement.hpp"

#include <algorithm>
#include <vector>

namespace clack::view {

namespace {

/// Whether any two balls are either level along the axis or too far apart along it to touch.
bool lie_in_layers(System const& system, Snapshot const& now, int axis) {
    std::vector<double> heights;
    for (Eigen::Index ball = 0; ball < system.count; ++ball)
        heights.push_back(now.positions(axis, ball));
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    if (system.boundary == Boundary::periodic && heights.size() > 1)
        heights.push_back(heights.front() + system.side);
    auto const touching = [&](double below, double above) {
        return above - below < system.diameter;
    };
    return std::adjacent_find(heights.begin(), heights.end(), touching) == heights.end();
}

} // namespace

int directions_of_motion(System const& system, Snapshot const& now) {
    int directions = 0;
    for (int axis = 0; axis < 3; ++axis) {
        bool const at_rest = (now.velocities.row(axis).array() == 0).all();
        if (!at_rest || !lie_in_layers(system, now, axis)) ++directions;
    }
    return directions;
}

std::string why_without_law(std::int64_t count, int directions) {
    if (count == 1) return "one ball keeps its speed: no law of chance";
    switch (directions) {
    case 1:
        return "in a row equal balls only hand on their speeds: no law of chance";
    case 2:
        return "in a plane: the laws of speed in space do not hold";
    default:
        return {};
    }
}

} // namespace clack::view
