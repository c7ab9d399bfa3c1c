#include "view/camera.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace clack::view {

namespace {

constexpr float half_angle_tangent =
    0.23f; // of the picture's height: 26 degrees, little distortion
constexpr float near_plane = 0.01f, far_plane = 100;

} // namespace

float Camera::focal_length() const { return 0.5f * zoom / half_angle_tangent; }

void Camera::orbit(float right, float up) {
    constexpr auto steepest = 0.499f * std::numbers::pi_v<float>;
    azimuth = std::remainder(azimuth - right, 2 * std::numbers::pi_v<float>);
    elevation = std::clamp(elevation + up, -steepest, steepest);
}

void Camera::pan(float to_right, float to_top) {
    float const height = distance() / focal_length();
    target -= height * (to_right * right() + to_top * up());
    target = target.cwiseMax(-1).cwiseMin(2);
}

void Camera::zoom_by(float factor) { zoom = std::clamp(zoom * factor, 0.3f, 100.f); }

Eigen::Vector3f Camera::towards_eye() const {
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
}

Eigen::Vector3f Camera::eye() const { return target + distance() * towards_eye(); }

Eigen::Vector3f Camera::right() const { return {-std::sin(azimuth), std::cos(azimuth), 0}; }

Eigen::Vector3f Camera::up() const { return towards_eye().cross(right()); }

Eigen::Matrix4f Camera::projection(PixelSize size) const {
    Eigen::Matrix4f look = Eigen::Matrix4f::Identity();
    look.block<1, 3>(0, 0) = right().transpose();
    look.block<1, 3>(1, 0) = up().transpose();
    look.block<1, 3>(2, 0) = towards_eye().transpose();
    look.block<3, 1>(0, 3) = -look.block<3, 3>(0, 0) * eye();
    Eigen::Matrix4f perspective = Eigen::Matrix4f::Zero();
    perspective(0, 0) = 2 * focal_length() / size.aspect();
    perspective(1, 1) = 2 * focal_length();
    perspective(2, 2) = (far_plane + near_plane) / (near_plane - far_plane);
    perspective(2, 3) = 2 * far_plane * near_plane / (near_plane - far_plane);
    perspective(3, 2) = -1;
    return perspective * look;
}

Ray Camera::ray_through(float x, float y, PixelSize size) const {
    auto const width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    float const along = size.aspect() * (x / width - 0.5f) / focal_length();
    float const upwards = (0.5f - y / height) / focal_length();
    return {eye(), (along * right() + upwards * up() - towards_eye()).normalized()};
}

bool Camera::cube_fits(float half_side, float distance, PixelSize size) const {
    constexpr float margin = 0.94f;
    float const tall = margin * half_angle_tangent, wide = tall * size.aspect();
    for (int corner = 0; corner < 8; ++corner) {
        Eigen::Vector3f const place =
            half_side * Eigen::Vector3f(corner & 1 ? 1.f : -1.f, corner & 2 ? 1.f : -1.f,
                                        corner & 4 ? 1.f : -1.f);
        float const depth = distance - place.dot(towards_eye());
        if (depth <= 0 || std::abs(place.dot(right())) > wide * depth ||
            std::abs(place.dot(up())) > tall * depth) {
            return false;
        }
    }
    return true;
}

void Camera::fit(PixelSize size, float overhang) {
    fitting_distance_ = 1;
    constexpr float step = 1.01f, farthest = 50;
    while (fitting_distance_ < farthest && !cube_fits(0.5f + overhang, fitting_distance_, size))
        fitting_distance_ *= step;
}

} // namespace clack::view
