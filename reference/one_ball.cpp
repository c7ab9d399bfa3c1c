#include "reference/one_ball.hpp"

namespace clack::reference {

namespace {

TriangleWave wave(System const& system, double const position, double const velocity) {
    return {system.accessible_side(), position - system.diameter / 2, velocity};
}

} // namespace

OneBall::OneBall(System const& system, Eigen::Vector3d const& position,
                 Eigen::Vector3d const& velocity)
    : system_(system), axes_{wave(system, position[0], velocity[0]),
                             wave(system, position[1], velocity[1]),
                             wave(system, position[2], velocity[2])} {}

Eigen::Vector3d OneBall::position(double const time) const {
    return Eigen::Vector3d(axes_[0].position(time), axes_[1].position(time),
                           axes_[2].position(time))
               .array() +
           system_.diameter / 2;
}

Eigen::Vector3d OneBall::velocity(double const time) const {
    return {axes_[0].velocity(time), axes_[1].velocity(time), axes_[2].velocity(time)};
}

std::int64_t OneBall::wall_collisions(double const time) const {
    return axes_[0].hits(time) + axes_[1].hits(time) + axes_[2].hits(time);
}

Eigen::Vector3d OneBall::mean_wall_force() const {
    return system_.mass / system_.accessible_side() * velocity(0).array().square();
}

} // namespace clack::reference
