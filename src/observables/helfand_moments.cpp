#include "observables/helfand_moments.hpp"

namespace clack {

HelfandMoments::HelfandMoments(System const& system, Snapshot const& now)
    : mass_(system.mass), time_(now.time) {
    for (auto const& velocity : now.velocities.colwise()) add_ball(velocity, 1);
}

void HelfandMoments::add_ball(Eigen::Vector3d const& velocity, double const sign) {
    kinetic_ += sign * mass_ * velocity * velocity.transpose();
    carried_ += sign * mass_ / 2 * velocity.squaredNorm() * velocity;
}

void HelfandMoments::operator()(Collision<double> const& collision) {
    if (collision.kind != CollisionKind::ball) return;
    stress_ = stress(collision.time);
    heat_ = heat(collision.time);
    time_ = collision.time;
    Eigen::Vector3d const kick = collision.impulse / mass_;
    Eigen::Vector3d const before_first = collision.velocity_first + kick;
    Eigen::Vector3d const before_second = collision.velocity_second - kick;
    add_ball(before_first, -1);
    add_ball(before_second, -1);
    add_ball(collision.velocity_first, 1);
    add_ball(collision.velocity_second, 1);
    double const handed_on =
        mass_ / 2 * (collision.velocity_second.squaredNorm() - before_second.squaredNorm());
    stress_ += collision.separation * collision.impulse.transpose();
    heat_ += collision.separation * handed_on;
}

} // namespace clack
