#include "observables/radial_distribution.hpp"

#include "observables/near_cells.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace clack {

RadialDistribution::RadialDistribution(System const& system, double const reach, int const bins)
    : system_(system), reach_(reach) {
    if (system.boundary != Boundary::periodic || bins < 1 ||
        !(reach > system.diameter && reach <= system.side / 2)) {
        throw std::invalid_argument(
            fmt::format("radial distribution up to {} in {} bins: needs a periodic cube, a bin, "
                        "and a reach above {}, the diameter, up to {}, half of the side",
                        reach, bins, system.diameter, system.side / 2));
    }
    pairs_.resize(static_cast<std::size_t>(bins));
}

void RadialDistribution::add(Snapshot const& snapshot) {
    double const per_length = static_cast<double>(pairs_.size()) / (reach_ - system_.diameter);
    NearCells const cells(system_, snapshot.positions, reach_);
    cells.each_pair([&](Eigen::Index, Eigen::Index, Eigen::Vector3d const& separation) {
        double const square = separation.squaredNorm();
        if (square >= reach_ * reach_) return;
        double const bin = (std::sqrt(square) - system_.diameter) * per_length;
        auto const last = static_cast<double>(pairs_.size() - 1);
        // Rounding leaves touching balls a hair nearer than the diameter.
        ++pairs_[static_cast<std::size_t>(std::clamp(bin, 0.0, last))];
    });
    ++snapshots_;
}

std::vector<double> RadialDistribution::distances() const {
    auto const bins = static_cast<double>(pairs_.size());
    std::vector<double> middles;
    for (std::size_t k = 0; k < pairs_.size(); ++k)
        middles.push_back(system_.diameter +
                          (static_cast<double>(k) + 0.5) * (reach_ - system_.diameter) / bins);
    return middles;
}

std::vector<double> RadialDistribution::values() const {
    double const half = (reach_ - system_.diameter) / static_cast<double>(pairs_.size()) / 2;
    double const balls = static_cast<double>(system_.count);
    std::vector<double> values = distances();
    for (std::size_t k = 0; k < values.size(); ++k) {
        double const r = values[k];
        double const shell =
            4 * std::numbers::pi / 3 * (std::pow(r + half, 3) - std::pow(r - half, 3));
        double const expected =
            static_cast<double>(snapshots_) * balls / 2 * system_.number_density() * shell;
        values[k] = snapshots_ > 0 ? static_cast<double>(pairs_[k]) / expected : 0;
    }
    return values;
}

double extrapolated(std::vector<double> const& places, std::vector<double> const& values,
                    double const to, int const degree) {
    auto const count = static_cast<Eigen::Index>(places.size());
    if (values.size() != places.size() || degree < 0 || count <= degree)
        throw std::invalid_argument("an extrapolation takes more values than its degree");
    // In units of the farthest place, so that no power outgrows the others.
    double const scale = std::abs(places.back() - to) + std::abs(places.front() - to);
    Eigen::MatrixXd powers(count, degree + 1);
    for (Eigen::Index k = 0; k < count; ++k)
        for (int power = 0; power <= degree; ++power)
            powers(k, power) = std::pow((places[static_cast<std::size_t>(k)] - to) / scale, power);
    Eigen::Map<Eigen::VectorXd const> const right(values.data(), count);
    return powers.colPivHouseholderQr().solve(right)[0];
}

} // namespace clack
