#include "observables/self_correlation.hpp"

#include <cassert>

namespace clack {

SelfCorrelation::SelfCorrelation(double const side, std::size_t const lag_max,
                                 std::size_t const origin_spacing)
    : side_(side), origin_spacing_(origin_spacing), displacement_(lag_max + 1),
      velocity_(lag_max + 1), counts_(lag_max + 1) {
    assert(origin_spacing > 0);
}

void SelfCorrelation::add(Snapshot const& snapshot) {
    Eigen::Matrix3Xd const places =
        side_ > 0 ? Eigen::Matrix3Xd(snapshot.positions + side_ * snapshot.images.cast<double>())
                  : snapshot.positions;
    if (seen_ % origin_spacing_ == 0) origins_.push_back({seen_, places, snapshot.velocities});
    while (seen_ - origins_.front().index > lag_max()) origins_.pop_front();
    auto const balls = static_cast<double>(places.cols());
    for (Origin const& origin : origins_) {
        std::size_t const lag = seen_ - origin.index;
        displacement_[lag] += (places - origin.positions).squaredNorm() / balls;
        velocity_[lag] += snapshot.velocities.cwiseProduct(origin.velocities).sum() / balls;
        ++counts_[lag];
    }
    ++seen_;
}

double SelfCorrelation::mean_square_displacement(std::size_t const lag) const {
    return displacement_.at(lag) / counts_.at(lag);
}

double SelfCorrelation::velocity_autocorrelation(std::size_t const lag) const {
    return velocity_.at(lag) / counts_.at(lag);
}

} // namespace clack
