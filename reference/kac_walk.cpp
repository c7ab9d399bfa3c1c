#include "reference/kac_walk.hpp"

#include "reference/two_balls.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace clack::reference {

KacWalk::KacWalk(Eigen::Matrix3Xd velocities, double const pair_rate, Momentum const momentum,
                 std::uint64_t const seed)
    : velocities_(std::move(velocities)), momentum_(momentum), random_(seed) {
    auto const count = static_cast<double>(velocities_.cols());
    // Two balls have at most all of the energy: no pair is ever faster.
    top_speed_ = std::sqrt(2 * velocities_.squaredNorm());
    candidate_rate_ = pair_rate * top_speed_ * count * (count - 1) / 2;
    next_ = wait();
}

void KacWalk::advance(double const time) {
    for (; next_ <= time; next_ += wait()) consider_pair();
}

double KacWalk::wait() { return -std::log1p(-uniform()) / candidate_rate_; }

void KacWalk::consider_pair() {
    auto const count = velocities_.cols();
    auto const draw = [&](Eigen::Index const below) {
        return static_cast<Eigen::Index>(uniform() * static_cast<double>(below));
    };
    Eigen::Index const i = draw(count);
    Eigen::Index j = draw(count - 1);
    if (j >= i) ++j;
    if (momentum_ == Momentum::reflected) {
        reflect(i);
        reflect(j);
    }
    Eigen::Vector3d const relative = velocities_.col(j) - velocities_.col(i);
    double const speed = relative.norm();
    if (uniform() * top_speed_ >= speed) return;
    Eigen::Vector3d const middle = (velocities_.col(i) + velocities_.col(j)) / 2;
    Eigen::Vector3d const half = direction() * (speed / 2);
    velocities_.col(i) = middle - half;
    velocities_.col(j) = middle + half;
    ++collisions_;
}

void KacWalk::reflect(Eigen::Index const ball) {
    std::uint64_t const bits = random_();
    for (int d = 0; d < 3; ++d)
        if (bits >> (63 - d) & 1) velocities_(d, ball) = -velocities_(d, ball);
}

Eigen::Vector3d KacWalk::direction() {
    double const z = 2 * uniform() - 1, angle = 2 * std::numbers::pi * uniform();
    double const radius = std::sqrt(1 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

double dilute_pair_rate(double const diameter, double const volume) {
    return std::numbers::pi * diameter * diameter / volume;
}

double walled_pair_rate(double const diameter, double const accessible_side) {
    double const x = diameter / accessible_side;
    return nearer_density(x) / (1 - nearer_probability(x)) / (4 * accessible_side);
}

} // namespace clack::reference
