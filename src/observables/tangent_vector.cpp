#include "observables/tangent_vector.hpp"

#include <cmath>
#include <utility>

namespace clack {

TangentVector::TangentVector(System const& system, Eigen::Matrix3Xd places,
                             Eigen::Matrix3Xd velocities, double const time)
    : system_(system), places_(std::move(places)), velocities_(std::move(velocities)),
      times_(static_cast<std::size_t>(places_.cols()), time) {}

void TangentVector::fly(std::int64_t const ball, double const time) {
    double& since = times_[static_cast<std::size_t>(ball)];
    places_.col(ball) += velocities_.col(ball) * (time - since);
    since = time;
}

void TangentVector::move_to(double const time) {
    for (Eigen::Index ball = 0; ball < places_.cols(); ++ball) fly(ball, time);
}

/// With n along the line of centres and v the relative velocity before the collision: the
/// difference r of the places is mirrored; the twin collides later by -(r.n)/(v.n), and so at the
/// line of centres turned by r + v (that time), which turns the exchange of velocities.
void TangentVector::operator()(Collision<double> const& collision) {
    auto const i = collision.first;
    fly(i, collision.time);
    if (collision.kind == CollisionKind::wall) {
        auto const axis = collision.second / 2;
        places_(axis, i) = -places_(axis, i);
        velocities_(axis, i) = -velocities_(axis, i);
        return;
    }
    auto const j = collision.second;
    fly(j, collision.time);
    Eigen::Vector3d const& q = collision.separation;
    double const q2 = q.squaredNorm();
    Eigen::Vector3d const before =
        collision.velocity_second - collision.velocity_first - 2 / system_.mass * collision.impulse;
    double const approach = before.dot(q);
    if (!(approach < 0)) return; // rounding let a grazing pair part

    Eigen::Vector3d const apart = places_.col(j) - places_.col(i);
    Eigen::Vector3d const faster = velocities_.col(j) - velocities_.col(i);
    double const along = apart.dot(q);
    Eigen::Vector3d const turned = apart - before * (along / approach);
    Eigen::Vector3d const place_kick = q * (along / q2);
    Eigen::Vector3d const velocity_kick =
        ((faster.dot(q) + before.dot(turned)) * q + approach * turned) / q2;
    places_.col(i) += place_kick;
    places_.col(j) -= place_kick;
    velocities_.col(i) += velocity_kick;
    velocities_.col(j) -= velocity_kick;
}

double TangentVector::normalise(double const time_unit) {
    double const diameter2 = system_.diameter * system_.diameter;
    double const length = std::sqrt(
        (places_.squaredNorm() + velocities_.squaredNorm() * time_unit * time_unit) / diameter2);
    places_ /= length;
    velocities_ /= length;
    return std::log(length);
}

} // namespace clack
