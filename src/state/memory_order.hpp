#pragma once
// Balls that are near in space are brought near in memory. Their permanent numbers stay, so this
// leaves no trace in the run.

#include "state/ball.hpp"
#include "state/huge_pages.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace clack {

/// Spreads the ten low bits of x to every third bit.
inline std::uint32_t every_third_bit(std::uint32_t x) {
    x = (x | (x << 16)) & 0x030000FFu;
    x = (x | (x << 8)) & 0x0300F00Fu;
    x = (x | (x << 4)) & 0x030C30C3u;
    return (x | (x << 2)) & 0x09249249u;
}

/// The balls' indexes in the order of Morton's curve over 1024^3 boxes; empty for so few balls that
/// they fit into the cache anyhow.
template <class Real>
std::vector<std::int32_t> memory_order(std::vector<Ball<Real>> const& balls, Real origin,
                                       Real extent) {
    constexpr std::size_t cached_count = 8192; // half a MiB of records
    std::vector<std::int32_t> order;
    if (balls.size() < cached_count || !(extent > 0)) return order;
    Real const boxes_per_length = 1024 / extent;
    std::vector<std::pair<std::uint32_t, std::int32_t>> keys(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        std::uint32_t key = 0;
        for (int d = 0; d < 3; ++d) {
            auto const box =
                static_cast<std::int32_t>((balls[i].point[d] - origin) * boxes_per_length);
            key |= every_third_bit(static_cast<std::uint32_t>(std::clamp(box, 0, 1023))) << d;
        }
        keys[i] = {key, static_cast<std::int32_t>(i)};
    }
    std::sort(keys.begin(), keys.end());
    order.reserve(balls.size());
    for (auto const& key : keys) order.push_back(key.second);
    return order;
}

/// In place, one cycle of the permutation after another: a copy would be the largest thing in
/// memory.
template <class Item>
void reorder(std::vector<Item>& items, std::vector<std::int32_t> const& order) {
    std::vector<bool> moved(items.size());
    for (std::size_t first = 0; first < items.size(); ++first) {
        if (moved[first]) continue;
        Item const displaced = items[first];
        std::size_t to = first;
        for (auto from = static_cast<std::size_t>(order[to]); from != first;
             from = static_cast<std::size_t>(order[to])) {
            items[to] = items[from];
            moved[to] = true;
            to = from;
        }
        items[to] = displaced;
        moved[to] = true;
    }
}

} // namespace clack
