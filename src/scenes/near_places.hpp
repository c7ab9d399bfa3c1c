#pragma once
// Which balls lie near a place, while balls are being put into an empty cube.

#include "state/system.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace clack {

/// Separation of two places, j minus i, by the nearest image where the cube repeats itself. Places
/// lie in [0, side).
inline Eigen::Vector3d separation_of(System const& system, Eigen::Vector3d const& i,
                                     Eigen::Vector3d const& j) {
    Eigen::Vector3d separation = j - i;
    if (system.boundary == Boundary::periodic)
        for (double& component : separation) {
            if (component > system.side / 2) component -= system.side;
            if (component < -system.side / 2) component += system.side;
        }
    return separation;
}

/// Squared length, added in one fixed order: the library's own order depends on the vector width.
inline double squared_length(Eigen::Vector3d const& vector) {
    return vector.x() * vector.x() + vector.y() * vector.y() + vector.z() * vector.z();
}

/// Balls in the cells of a grid whose edge is at least `reach`; cells share the buckets of a table
/// that is as large as the number of balls, so that an almost empty cube costs no memory.
class NearPlaces {
public:
    NearPlaces(System const& system, double reach, std::int64_t capacity);

    /// Adds the next ball: they are numbered in the order in which they come.
    void add(Eigen::Vector3d const& place);

    /// Calls visit(ball) for all balls that may lie within reach, and others, until it returns
    /// Visit::stop.
    enum class Visit { go_on, stop };
    template <class Visitor> void visit_near(Eigen::Vector3d const& place, Visitor visit) const {
        Span const x = cells_about(place.x()), y = cells_about(place.y()),
                   z = cells_about(place.z());
        for (std::int64_t k = z.first; k <= z.last; ++k)
            for (std::int64_t j = y.first; j <= y.last; ++j)
                for (std::int64_t i = x.first; i <= x.last; ++i)
                    for (auto ball = first_[bucket(wrapped(i), wrapped(j), wrapped(k))]; ball >= 0;
                         ball = next_[static_cast<std::size_t>(ball)])
                        if (visit(ball) == Visit::stop) return;
    }

private:
    struct Span {
        std::int64_t first, last;
    };
    std::int64_t cell(double coordinate) const;
    Span cells_about(double coordinate) const;
    std::int64_t wrapped(std::int64_t cell) const {
        return cell < 0 ? cell + cells_ : cell >= cells_ ? cell - cells_ : cell;
    }
    /// A bucket of its own for each cell where there are so many. Where there are fewer, rows of
    /// cells are scattered among them: balls in one plane of a wide cube must not share one.
    std::size_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const {
        auto const i = static_cast<std::uint64_t>(x), j = static_cast<std::uint64_t>(y),
                   k = static_cast<std::uint64_t>(z), m = static_cast<std::uint64_t>(cells_);
        if (each_its_own_) return i + m * (j + m * k);
        std::uint64_t const scattered = j * 0x9e3779b97f4a7c15 + k * 0xc2b2ae3d27d4eb4f;
        return (i + (scattered >> 32)) & mask_;
    }

    Boundary boundary_;
    std::int64_t cells_; // per side
    double cells_per_length_;
    bool each_its_own_; // bucket, for each cell
    std::uint64_t mask_;
    std::vector<std::int32_t> first_; // of each bucket: its latest ball, -1 for none
    std::vector<std::int32_t> next_;  // of each ball: the one before it in its bucket
};

} // namespace clack
