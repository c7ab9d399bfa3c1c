#include "scenes/near_places.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace clack {

namespace {

constexpr std::int64_t most_cells = std::int64_t{1} << 30; // per side: the widest cube's

} // namespace

NearPlaces::NearPlaces(System const& system, double reach, std::int64_t capacity)
    : boundary_(system.boundary),
      cells_(static_cast<std::int64_t>(
          std::clamp(std::floor(system.side / reach), 1.0, static_cast<double>(most_cells)))),
      cells_per_length_(static_cast<double>(cells_) / system.side) {
    double const per_side = static_cast<double>(cells_);
    double const cell_count = per_side * per_side * per_side;
    double const most_buckets = 4.0 * static_cast<double>(capacity);
    double const wanted = std::min(cell_count, most_buckets);
    each_its_own_ = cell_count <= most_buckets;
    mask_ = std::bit_ceil(static_cast<std::uint64_t>(wanted)) - 1;
    first_.assign(mask_ + 1, -1);
    next_.reserve(static_cast<std::size_t>(capacity));
}

void NearPlaces::add(Eigen::Vector3d const& place) {
    auto& first = first_[bucket(cell(place.x()), cell(place.y()), cell(place.z()))];
    next_.push_back(first);
    first = static_cast<std::int32_t>(next_.size()) - 1;
}

std::int64_t NearPlaces::cell(double coordinate) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(coordinate * cells_per_length_), 0,
                                    cells_ - 1);
}

NearPlaces::Span NearPlaces::cells_about(double coordinate) const {
    std::int64_t const own = cell(coordinate);
    if (boundary_ == Boundary::walls)
        return {std::max<std::int64_t>(own - 1, 0), std::min(own + 1, cells_ - 1)};
    // Fewer than three cells: each once.
    return cells_ < 3 ? Span{0, cells_ - 1} : Span{own - 1, own + 1};
}

} // namespace clack
