#include "observables/density_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace clack {

DensityProfile::DensityProfile(System const& system, double const reach, int const bins,
                               double const inset)
    : system_(system), reach_(reach), inset_(inset) {
    double const nearest = system.diameter / 2;
    if (system.boundary != Boundary::walls || bins < 1 ||
        !(reach > nearest && reach <= system.side / 2) ||
        !(inset >= 0 && 2 * inset < system.accessible_side())) {
        throw std::invalid_argument(fmt::format(
            "density profile up to {} in {} bins with an inset of {}: needs walls, a bin, a reach "
            "above {} up to {}, and an inset below half of {}",
            reach, bins, inset, nearest, system.side / 2, system.accessible_side()));
    }
    balls_.resize(static_cast<std::size_t>(bins));
}

double DensityProfile::bin_width() const {
    return (reach_ - system_.diameter / 2) / static_cast<double>(balls_.size());
}

void DensityProfile::add(Snapshot const& snapshot) {
    double const nearest = system_.diameter / 2;
    auto const last = static_cast<double>(balls_.size() - 1);
    for (auto const& place : snapshot.positions.colwise()) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            double const distance = std::min(place[axis], system_.side - place[axis]);
            if (distance >= reach_) continue;
            double const across[] = {place[(axis + 1) % 3], place[(axis + 2) % 3]};
            bool const over_the_face =
                std::all_of(std::begin(across), std::end(across), [&](double const along) {
                    return std::min(along, system_.side - along) >= nearest + inset_ ||
                           inset_ == 0; // rounding may leave a ball a hair beyond its plane
                });
            if (!over_the_face) continue;
            double const bin = (distance - nearest) / bin_width();
            ++balls_[static_cast<std::size_t>(std::clamp(bin, 0.0, last))];
        }
    }
    ++snapshots_;
}

std::vector<double> DensityProfile::distances() const {
    std::vector<double> middles;
    for (std::size_t k = 0; k < balls_.size(); ++k)
        middles.push_back(system_.diameter / 2 + (static_cast<double>(k) + 0.5) * bin_width());
    return middles;
}

std::vector<double> DensityProfile::values() const {
    double const width = system_.accessible_side() - 2 * inset_;
    double const volume = 6 * width * width * bin_width() *
                          static_cast<double>(std::max<std::int64_t>(snapshots_, 1));
    std::vector<double> values;
    for (std::int64_t const count : balls_) values.push_back(static_cast<double>(count) / volume);
    return values;
}

double density_in_the_middle(System const& system, Snapshot const& snapshot,
                             double const half_width) {
    double sum = 0;
    for (auto const& place : snapshot.positions.colwise()) {
        double weight = 1; // its integral along an axis is half_width
        for (double const along : place) {
            double const part = (along - system.side / 2) / half_width;
            double const cosine = std::abs(part) < 1 ? std::cos(std::numbers::pi / 2 * part) : 0;
            weight *= cosine * cosine;
        }
        sum += weight;
    }
    return sum / std::pow(half_width, 3);
}

} // namespace clack
