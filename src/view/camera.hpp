#pragma once
// Where the cube is looked at from.

#include <Eigen/Core>

namespace clack::view {

/// Size of a picture in pixels.
struct PixelSize {
    int width = 0, height = 0;
    bool operator==(PixelSize const&) const = default;
    float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
};

/// A ray of sight.
struct Ray {
    Eigen::Vector3f origin, direction; // unit length
};

/// A camera that orbits a point, z upwards, and zooms with its lens: near balls stay round, and
/// none is ever behind it. Angles in radians, lengths in sides of the cube.
class Camera {
public:
    float azimuth = -1.05f, elevation = 0.35f, zoom = 1;
    Eigen::Vector3f target = Eigen::Vector3f::Constant(0.5f);

    void orbit(float right, float up);
    void pan(float to_right, float to_top); // in heights of the picture
    void zoom_by(float factor);

    /// With zoom 1 and the centre as its target, the whole cube fits a picture of this size, and
    /// what sticks out of its faces so far.
    void fit(PixelSize size, float overhang = 0);

    Eigen::Vector3f eye() const;
    Eigen::Vector3f towards_eye() const; // unit length
    Eigen::Vector3f right() const;
    Eigen::Vector3f up() const;
    /// From the unit cube to clip space. Depth is not for use: balls bring their own.
    Eigen::Matrix4f projection(PixelSize size) const;
    Ray ray_through(float x, float y, PixelSize size) const; // pixels from the upper left

    /// Heights of a picture that an object of length 1 at distance 1 covers.
    float focal_length() const;
    float distance() const { return fitting_distance_; }

private:
    bool cube_fits(float half_side, float distance, PixelSize size) const;

    float fitting_distance_ = 3;
};

} // namespace clack::view
