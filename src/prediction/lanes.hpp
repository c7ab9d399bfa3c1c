#pragma once
// Eight numbers at a time, or four where the registers are narrower, in the vector types of g++ and
// clang++. The bits are the same, and those of one at a time.

#include "state/ball.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace clack {

#ifdef __AVX512VL__
constexpr int lane_count = 8;
#else
constexpr int lane_count = 4; // wider vectors would be taken to pieces, at three times the cost
#endif

template <class Real> struct LaneTypes;
template <> struct LaneTypes<float> {
    using Numbers [[gnu::vector_size(lane_count * sizeof(float))]] = float;
    using Integers [[gnu::vector_size(lane_count * sizeof(float))]] = std::int32_t;
};
template <> struct LaneTypes<double> {
    using Numbers [[gnu::vector_size(lane_count * sizeof(double))]] = double;
    using Integers [[gnu::vector_size(lane_count * sizeof(double))]] = std::int64_t;
};
template <class Real> using Lanes = typename LaneTypes<Real>::Numbers;
template <class Real> using LaneIntegers = typename LaneTypes<Real>::Integers;

/// As many numbers as lanes, or balls beside them, from one place to another: at once, as by
/// `fours_at`. Without AVX-512, and with `bits_of` in one instruction there, lists are 1.05 times
/// as fast.
template <class Number>
[[gnu::always_inline]] inline void copy_lanes(Number const* from, Number* to) {
    using Some [[gnu::vector_size(lane_count * sizeof(Number)), gnu::may_alias,
                 gnu::aligned(alignof(Number))]] = Number;
    *reinterpret_cast<Some*>(to) = *reinterpret_cast<Some const*>(from);
}

template <class Number>
constexpr bool is_lanes =
    std::is_same_v<Number, Lanes<float>> || std::is_same_v<Number, Lanes<double>>;

// The same three words for one number and for many, so that one source serves both.
template <class Number> inline Number square_root(Number x) {
    using std::sqrt;
    if constexpr (is_lanes<Number> || std::is_same_v<Number, Twos>) {
        constexpr int lanes = sizeof x / sizeof x[0];
        Number root;
        for (int lane = 0; lane < lanes; ++lane) root[lane] = sqrt(x[lane]);
        return root;
    } else {
        return sqrt(x);
    }
}
template <class Condition, class Number>
inline Number select(Condition condition, Number yes, Number no) {
    return condition ? yes : no;
}
template <class Number> inline Number later(Number a, Number b) { return select(a > b, a, b); }

template <class Real> inline Lanes<Real> broadcast(Real x) {
    return x - Lanes<Real>{}; // every bit of x, minus zero's too
}

/// The lanes made one, pair by pair.
template <class Vector, class Pairwise>
[[gnu::always_inline]] inline auto folded(Vector x, Pairwise&& pairwise) {
#ifdef __AVX512VL__
    x = pairwise(x, __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3));
    x = pairwise(x, __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5));
    x = pairwise(x, __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6));
#else
    x = pairwise(x, __builtin_shufflevector(x, x, 2, 3, 0, 1));
    x = pairwise(x, __builtin_shufflevector(x, x, 1, 0, 3, 2));
#endif
    return x[0];
}

/// A bit for each lane in which a condition holds.
template <class Condition> [[gnu::always_inline]] inline std::uint32_t bits_of(Condition holds) {
#ifdef __AVX512VL__ // as at the end, in one instruction
    if constexpr (sizeof holds == sizeof(__m512i)) {
        auto const lanes = reinterpret_cast<__m512i>(holds);
        return _mm512_test_epi64_mask(lanes, lanes);
    } else {
        auto const lanes = reinterpret_cast<__m256i>(holds);
        return _mm256_test_epi32_mask(lanes, lanes);
    }
#elif defined __AVX2__
    if constexpr (sizeof holds == sizeof(__m256d)) {
        return static_cast<std::uint32_t>(_mm256_movemask_pd(reinterpret_cast<__m256d>(holds)));
    } else {
        return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(holds)));
    }
#else
    Condition bits{};
    for (int lane = 0; lane < lane_count; ++lane) bits[lane] = 1 << lane;
    return static_cast<std::uint32_t>(folded(
        Condition(holds & bits), [](Condition const& a, Condition const& b) { return a | b; }));
#endif
}

#ifdef __AVX512VL__
/// A bit for each lane in which two numbers stand in a relation. g++ 12 would make a vector of the
/// mask, and a mask of the vector.
template <int relation, class Numbers>
[[gnu::always_inline]] inline std::uint32_t bits_related(Numbers const& a, Numbers const& b) {
    if constexpr (sizeof a == sizeof(__m512d)) {
        return _mm512_cmp_pd_mask(reinterpret_cast<__m512d>(a), reinterpret_cast<__m512d>(b),
                                  relation);
    } else {
        return _mm256_cmp_ps_mask(reinterpret_cast<__m256>(a), reinterpret_cast<__m256>(b),
                                  relation);
    }
}
#endif

/// A bit for each lane in which two numbers are equal, or the first is smaller.
template <class Numbers>
[[gnu::always_inline]] inline std::uint32_t bits_of_equal(Numbers const& a, Numbers const& b) {
#ifdef __AVX512VL__
    return bits_related<_CMP_EQ_OQ>(a, b);
#else
    return bits_of(a == b);
#endif
}
template <class Numbers>
[[gnu::always_inline]] inline std::uint32_t bits_of_less(Numbers const& a, Numbers const& b) {
#ifdef __AVX512VL__
    return bits_related<_CMP_LT_OQ>(a, b);
#else
    return bits_of(a < b);
#endif
}

/// Calls visit(lane) for each lane in which a condition holds.
template <class Condition, class Visit>
[[gnu::always_inline]] inline void for_each_lane(Condition holds, Visit&& visit) {
    for (std::uint32_t bits = bits_of(holds); bits != 0; bits &= bits - 1)
        visit(static_cast<std::size_t>(__builtin_ctz(bits)));
}

/// Writes the balls of those lanes that `bits` names one after the other, and perhaps others behind
/// them, within as many as there are lanes; returns where they end. Which pass cannot be foretold,
/// so that a loop over them would be guessed wrongly each time: without it lists are 1.09 to 1.12
/// times as fast.
[[gnu::always_inline]] inline std::int32_t* write_chosen(std::int32_t const* balls,
                                                         std::uint32_t bits, std::int32_t* to) {
#ifdef __AVX512VL__
    auto const some = _mm256_loadu_si256(reinterpret_cast<__m256i const*>(balls));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), some));
    return to + std::popcount(bits);
#else
    for (int lane = 0; lane < lane_count; ++lane) {
        *to = balls[lane];
        to += bits >> lane & 1;
    }
    return to;
#endif
}

/// Gathers the balls of blocks one after the other. A block is so many places and a tail, whose
/// last four bits say how many places count, and whose sign says that no chain goes on behind it;
/// else all places count. Where the balls are written there must be room for sixteen more.
template <std::int32_t places> class BlockGatherer {
public:
    explicit BlockGatherer(std::int32_t* to) : end_(to) {}

    std::int32_t* end() const { return end_; }
    bool any_chain() const { return all_tails_ >= 0; }

    /// Whole, which takes neither loop nor branch; the next block overwrites what does not count.
    [[gnu::always_inline]] void add(std::int32_t const* block) {
        using Whole [[gnu::vector_size(4 * (places + 1))]] = std::int32_t;
        Whole copied; // in one register
        std::memcpy(&copied, block, sizeof copied);
        std::memcpy(end_, &copied, sizeof copied);
        end_ += block[places] & 15;
        all_tails_ &= block[places];
    }

private:
    std::int32_t* end_;
    std::int32_t all_tails_ = -1;
};

/// The same of rows of three blocks that lie beside each other in memory.
template <std::int32_t places> class RowGatherer : public BlockGatherer<places> {
public:
    using BlockGatherer<places>::BlockGatherer;

    [[gnu::always_inline]] void add(std::int32_t const* blocks) {
        for (std::ptrdiff_t k = 0; k < 3; ++k)
            BlockGatherer<places>::add(blocks + k * (places + 1));
    }
};

#ifdef __AVX512VL__
/// In one register: 1.03 to 1.04 times as fast at packing fraction 0.05, 1.05 to 1.09 at 0.20.
template <> class RowGatherer<3> {
public:
    explicit RowGatherer(std::int32_t* to) : end_(to) {}

    std::int32_t* end() const { return end_; }
    bool any_chain() const { return (_mm512_movepi32_mask(all_tails_) & twelve) != twelve; }

    [[gnu::always_inline]] void add(std::int32_t const* blocks) {
        // A tail is -16 and the count, or not negative: above what stands here for a place, then.
        constexpr std::int32_t no = std::numeric_limits<std::int32_t>::max();
        __m512i const below = _mm512_setr_epi32(-16, -15, -14, no, -16, -15, -14, no, //
                                                -16, -15, -14, no, no, no, no, no);
        __m512i const balls = _mm512_maskz_loadu_epi32(twelve, blocks);
        __m512i const tails = _mm512_shuffle_epi32(balls, _MM_PERM_DDDD);
        __mmask16 const counts = _mm512_cmplt_epi32_mask(below, tails);
        _mm512_storeu_si512(end_, _mm512_maskz_compress_epi32(counts, balls));
        end_ += std::popcount(static_cast<std::uint32_t>(counts));
        all_tails_ = _mm512_and_epi32(all_tails_, tails);
    }

private:
    static constexpr __mmask16 twelve = 0x0fff;

    std::int32_t* end_;
    __m512i all_tails_ = _mm512_set1_epi32(-1);
};
#endif

/// The records of so many balls, turned: one vector a component.
template <class Real> struct BallLanes { Lanes<Real> x, y, z, time, vx, vy, vz, note; };

/// Four numbers each of so many balls, turned.
template <class Real> struct TurnedFours { Lanes<Real> first, second, third, fourth; };

#ifdef __AVX512VL__
/// Two fours beside each other. g++ 12 would make two instructions of it.
[[gnu::always_inline]] inline Lanes<double> beside(Fours<double> low, Fours<double> high) {
    auto const wide = _mm512_castpd256_pd512(reinterpret_cast<__m256d>(low));
    return reinterpret_cast<Lanes<double>>(
        _mm512_insertf64x4(wide, reinterpret_cast<__m256d>(high), 1));
}
[[gnu::always_inline]] inline Lanes<float> beside(Fours<float> low, Fours<float> high) {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
#endif

template <class Real, class Load>
[[gnu::always_inline]] inline TurnedFours<Real> turned(Load&& four_of) {
    using V = Lanes<Real>;
#ifdef __AVX512VL__
    // In such an order that no shuffle but the last crosses lanes and all end in their own order.
    V const row0 = beside(four_of(0), four_of(2)), row1 = beside(four_of(1), four_of(3));
    V const row2 = beside(four_of(4), four_of(6)), row3 = beside(four_of(5), four_of(7));
    auto const evens = [](V a, V b) {
        return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    };
    auto const odds = [](V a, V b) {
        return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    };
    auto const lows = [](V a, V b) {
        return __builtin_shufflevector(a, b, 0, 1, 4, 5, 8, 9, 12, 13);
    };
    auto const highs = [](V a, V b) {
        return __builtin_shufflevector(a, b, 2, 3, 6, 7, 10, 11, 14, 15);
    };
#else
    V const row0 = four_of(0), row1 = four_of(1), row2 = four_of(2), row3 = four_of(3);
    auto const evens = [](V a, V b) { return __builtin_shufflevector(a, b, 0, 4, 2, 6); };
    auto const odds = [](V a, V b) { return __builtin_shufflevector(a, b, 1, 5, 3, 7); };
    auto const lows = [](V a, V b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5); };
    auto const highs = [](V a, V b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7); };
#endif
    V const evens01 = evens(row0, row1), evens23 = evens(row2, row3);
    V const odds01 = odds(row0, row1), odds23 = odds(row2, row3);
    return {lows(evens01, evens23), lows(odds01, odds23), highs(evens01, evens23),
            highs(odds01, odds23)};
}

template <class Real>
[[gnu::always_inline]] inline BallLanes<Real> load_balls(Ball<Real> const* balls,
                                                         std::int32_t const* chosen) {
    auto const place = turned<Real>([&](int k) { return point_and_time(balls[chosen[k]]); });
    auto const way = turned<Real>([&](int k) { return velocity_four(balls[chosen[k]]); });
    return {place.first, place.second, place.third, place.fourth,
            way.first,   way.second,   way.third,   way.fourth};
}

} // namespace clack
