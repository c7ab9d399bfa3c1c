#include "view/ball_order.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace clack::view {

namespace {

/// Perspective makes a ball's outline an ellipse around a point beside its centre: discs of these
/// shares of its radius lie within it, or around it.
struct Shares {
    float inner, outer;
};

///   angle    radius over distance
///   tangent  of the angle between the middle of the picture and its corner
Shares shares_of(float angle, float tangent) {
    return {1 - angle * (0.5f + tangent),
            std::sqrt(1 + tangent * tangent) * (1 + angle * (0.5f + tangent))};
}

Eigen::Vector3f place_of(DrawnBall const& ball) { return {ball.x, ball.y, ball.z}; }

} // namespace

/// A counting sort over 65536 shells: what shares one is too near to matter.
void BallOrder::sort_by_distance(Picture const& picture, Eigen::Vector3f const& eye) {
    auto const& balls = picture.balls;
    std::vector<float> distances(balls.size());
    float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        distances[i] = (place_of(balls[i]) - eye).norm();
        nearest = std::min(nearest, distances[i]);
        farthest = std::max(farthest, distances[i]);
    }
    constexpr std::size_t shells = 65536;
    float const scale = static_cast<float>(shells - 1) / std::max(farthest - nearest, 1e-30f);
    keys_.resize(balls.size());
    starts_.assign(shells + 1, 0);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        keys_[i] = static_cast<std::uint16_t>((distances[i] - nearest) * scale);
        ++starts_[keys_[i] + 1u];
    }
    for (std::size_t shell = 0; shell < shells; ++shell) starts_[shell + 1] += starts_[shell];
    order_.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i)
        order_[starts_[keys_[i]]++] = static_cast<std::uint32_t>(i);
}

void BallOrder::clear_screen(float radius_in_pixels, PixelSize size) {
    cell_ = std::clamp(radius_in_pixels / 4, 1.f, 8.f);
    columns_ = static_cast<int>(static_cast<float>(size.width) / cell_) + 1;
    rows_ = static_cast<int>(static_cast<float>(size.height) / cell_) + 1;
    covered_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
}

/// Calls visit(first cell, one past the last) for each row of cells that a disc's square touches,
/// as long as it returns true; within the picture.
template <class Visit> bool BallOrder::each_cell_row(Disc const& disc, Visit const& visit) const {
    auto const cell_of = [&](float pixel, int cells) {
        return std::clamp(static_cast<int>(std::floor(pixel / cell_)), 0, cells);
    };
    int const left = cell_of(disc.x - disc.radius, columns_);
    int const right = cell_of(disc.x + disc.radius + cell_, columns_);
    int const top = cell_of(disc.y - disc.radius, rows_);
    int const bottom = cell_of(disc.y + disc.radius + cell_, rows_);
    for (int row = top; row < bottom; ++row) {
        if (!visit(row, left, right)) return false;
    }
    return true;
}

bool BallOrder::is_hidden(Disc const& disc) const {
    return each_cell_row(disc, [&](int row, int left, int right) {
        float const top = static_cast<float>(row) * cell_ - disc.y;
        float const away = std::max({top, -top - cell_, 0.f}); // of the row's nearest point
        float const half = std::sqrt(std::max(disc.radius * disc.radius - away * away, 0.f));
        int const first = std::max(left, static_cast<int>(std::floor((disc.x - half) / cell_)));
        int const last = std::min(right, static_cast<int>(std::floor((disc.x + half) / cell_)) + 1);
        auto const begin = covered_.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
        return first >= last || std::all_of(begin + first, begin + last,
                                            [](std::uint8_t cell) { return cell != 0; });
    });
}

/// Marks the cells that lie within the disc whole.
void BallOrder::cover(Disc const& disc) {
    each_cell_row(disc, [&](int row, int left, int right) {
        float const top = static_cast<float>(row) * cell_ - disc.y;
        float const away = std::max(std::abs(top), std::abs(top + cell_));
        if (away >= disc.radius) return true;
        float const half = std::sqrt(disc.radius * disc.radius - away * away);
        int const first = std::max(left, static_cast<int>(std::ceil((disc.x - half) / cell_)));
        int const last = std::min(right, static_cast<int>(std::floor((disc.x + half) / cell_)));
        auto const begin = covered_.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
        if (first < last) std::fill(begin + first, begin + last, std::uint8_t{1});
        return true;
    });
}

VisibleBalls BallOrder::visible(Picture const& picture, Camera const& camera, PixelSize size,
                                std::stop_token const& stop) {
    auto const eye = camera.eye();
    Eigen::Matrix4f const projection = camera.projection(size);
    auto const height = static_cast<float>(size.height), width = static_cast<float>(size.width);
    float const scale = picture.radius * camera.focal_length() * height;
    float const tangent =
        0.5f * std::sqrt(1 + size.aspect() * size.aspect()) / camera.focal_length();
    sort_by_distance(picture, eye);
    clear_screen(scale / camera.distance(), size);
    VisibleBalls visible;
    for (auto const i : order_) {
        if (stop.stop_requested()) break;
        DrawnBall const& ball = picture.balls[i];
        if (picture.cut.hides(place_of(ball))) continue;
        Eigen::Vector4f const projected = projection * place_of(ball).homogeneous();
        float const depth = projected.w();
        if (depth < 1.5f * picture.radius) continue; // at the eye, or behind it
        float const radius = scale / depth;
        auto const shares = shares_of(picture.radius / depth, tangent);
        Disc disc{(projected.x() / depth + 1) * width / 2, (1 - projected.y() / depth) * height / 2,
                  shares.outer * radius + 0.5f};
        if (disc.x + disc.radius < 0 || disc.x - disc.radius > width || disc.y + disc.radius < 0 ||
            disc.y - disc.radius > height || is_hidden(disc)) {
            continue;
        }
        disc.radius = shares.inner * radius;
        cover(disc);
        (radius < dot_radius ? visible.dots : visible.near).push_back(ball);
    }
    return visible;
}

Prepared BallOrder::prepare(Picture picture, Camera const& camera, PixelSize size,
                            std::stop_token const& stop) {
    Prepared prepared{std::move(picture), camera, {}};
    if (!stop.stop_requested()) prepared.visible = visible(prepared.picture, camera, size, stop);
    prepared.picture.balls = {};
    return prepared;
}

} // namespace clack::view
