#pragma once
// Sixteen single-precision numbers at a time, for what needs no more: to sort out which balls are
// worth an exact look.

#include <cstdint>
#include <cstring>

namespace clack {

constexpr int screen_lanes = 16;
using Floats [[gnu::vector_size(screen_lanes * sizeof(float))]] = float;
using Integers [[gnu::vector_size(screen_lanes * sizeof(std::int32_t))]] = std::int32_t;

inline Integers lane_numbers() {
    return Integers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
}
inline Integers load_sixteen(std::int32_t const* numbers) {
    Integers loaded;
    std::memcpy(&loaded, numbers, sizeof loaded);
    return loaded;
}

/// The least of sixteen numbers.
[[gnu::always_inline]] inline std::int32_t least_of(Integers x) {
    auto const fold = [&](Integers const& other) { x = x < other ? x : other; };
    fold(__builtin_shufflevector(x, x, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7));
    fold(__builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3));
    fold(__builtin_shufflevector(x, x, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1));
    fold(__builtin_shufflevector(x, x, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0));
    return x[0];
}

/// Four numbers of each of sixteen balls.
struct Quads {
    Floats x, y, z, w;
};

/// The quads at `first + stride * chosen[k]`, turned: one vector a component.
template <std::size_t stride>
[[gnu::always_inline]] inline Quads load_quads(float const* first, std::int32_t const* chosen) {
    using Quad [[gnu::vector_size(16)]] = float;
    auto const row_of = [&](int k) {
        Quad loaded;
        std::memcpy(&loaded, first + stride * static_cast<std::size_t>(chosen[k]), sizeof loaded);
        return loaded;
    };
    // Row k holds the balls k, k + 4, k + 8 and k + 12, so that they end in their own order.
    Floats row[4];
    for (int k = 0; k < 4; ++k) {
        auto const low = __builtin_shufflevector(row_of(k), row_of(k + 4), 0, 1, 2, 3, 4, 5, 6, 7);
        auto const high =
            __builtin_shufflevector(row_of(k + 8), row_of(k + 12), 0, 1, 2, 3, 4, 5, 6, 7);
        row[k] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13,
                                         14, 15);
    }
    auto const firsts = [](Floats a, Floats b) {
        return __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13,
                                       29);
    };
    auto const lasts = [](Floats a, Floats b) {
        return __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15,
                                       31);
    };
    auto const first_pairs = [](Floats a, Floats b) {
        return __builtin_shufflevector(a, b, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28,
                                       29);
    };
    auto const last_pairs = [](Floats a, Floats b) {
        return __builtin_shufflevector(a, b, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30,
                                       31);
    };
    Floats const xy01 = firsts(row[0], row[1]), zw01 = lasts(row[0], row[1]);
    Floats const xy23 = firsts(row[2], row[3]), zw23 = lasts(row[2], row[3]);
    return {first_pairs(xy01, xy23), last_pairs(xy01, xy23), first_pairs(zw01, zw23),
            last_pairs(zw01, zw23)};
}

} // namespace clack
