#pragma once
// Which of sixteen balls might be touched first, seen through single precision: a screen that errs
// on the side of caution only, so that the few that pass it are predicted exactly and the rest need
// not be.

#include "prediction/sixteen.hpp"
#include "state/ball.hpp"
#include "state/container.hpp"
#include "state/huge_pages.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace clack {

/// A record in single precision, in diameters and epochs: half a cache line.
struct alignas(32) Sketch {
    float place[3]; // of the record's point
    float time;     // when the flight began
    float way[3];   // diameters per epoch
    float blur;     // how far the ball may be from where the sketch has it, within the epoch
};

/// Lower bounds of contact times. The sketched lines run within their blurs of the true ones for
/// the whole epoch, so spheres that are wider by the blurs of both touch no later than the balls
/// do, and what the bound itself loses to rounding is made up for where it is formed. After the
/// epoch it bounds nothing, but then nothing that was predicted in it happens.
template <class Container> class Screen {
public:
    /// Bounds, in an order that integers have too: greater for later moments. The last four bits
    /// are the candidate's place among the sixteen.
    using Keys = Integers;
    static constexpr std::int32_t never = std::numeric_limits<std::int32_t>::max();

    Screen(System const& system, double epoch_length)
        : per_diameter_(1 / system.diameter), per_epoch_(1 / epoch_length),
          side_(static_cast<float>(system.side * per_diameter_)), inverse_side_(1 / side_) {}

    void resize(std::size_t count) {
        reserve_large(sketches_, count);
        sketches_.resize(count);
    }

    void draw(std::int32_t ball, Ball<double> const& record) {
        Sketch& sketch = sketches_[static_cast<std::size_t>(ball)];
        double const ways = per_diameter_ / per_epoch_;
        float farthest = 0;
        for (int d = 0; d < 3; ++d) {
            sketch.place[d] = static_cast<float>(record.point[d] * per_diameter_);
            sketch.way[d] = static_cast<float>(record.velocity[d] * ways);
            farthest += std::abs(sketch.way[d]);
        }
        sketch.time = static_cast<float>(record.time * per_epoch_);
        constexpr int roundings = 16; // counted: under 12 for place, way and time
        sketch.blur = roundings * unit * (side_ + farthest);
    }

    /// The key of the last moment that is not later than a time.
    std::int32_t key_at(double time) const {
        auto const rounded = static_cast<float>(time * per_epoch_) * (1 + 4 * unit);
        if (!(rounded < std::numeric_limits<float>::max())) return never - screen_lanes;
        return std::bit_cast<std::int32_t>(rounded > 0 ? rounded : 0.0f) | (screen_lanes - 1);
    }

    /// For sixteen candidates the moment before which ball i does not touch them; `never` for those
    /// that it passes by, and for itself.
    [[gnu::always_inline]] Keys keys(std::int32_t i, std::int32_t const* candidates,
                                     double now_exact) const {
        Sketch const& own = sketches_[static_cast<std::size_t>(i)];
        float const* const first = sketches_.front().place;
        Quads const place = load_quads<8>(first, candidates);
        Quads const way = load_quads<8>(first + 4, candidates);
        auto const now = static_cast<float>(now_exact * per_epoch_);
        Floats const flown = now - place.w;
        float const own_flown = now - own.time;
        auto const apart = [&](Floats there, Floats velocity, int d) {
            Floats const r = (there + velocity * flown) - (own.place[d] + own.way[d] * own_flown);
            if constexpr (Container::boundary == Boundary::periodic) {
                return r - nearest_integer<Floats, float>(r * inverse_side_) * side_;
            } else {
                return r;
            }
        };
        Floats const x = apart(place.x, way.x, 0), y = apart(place.y, way.y, 1),
                     z = apart(place.z, way.z, 2);
        Floats const vx = way.x - own.way[0], vy = way.y - own.way[1], vz = way.z - own.way[2];
        Floats const r2 = x * x + y * y + z * z;
        Floats const v2 = vx * vx + vy * vy + vz * vz;
        Floats const b = x * vx + y * vy + z * vz;
        Floats const reach = way.w + (own.blur + 1);
        Floats const c = r2 - (reach * reach + slack * r2);
        Floats const disc = b * b - c * v2;
        // The slack in c makes sqrt(disc) over a thousandth of |r||v| where c > 0: what b and the
        // root lose is little beside it.
        Floats const wait = c / (root(disc) - b) * (1 - 0x1p-11f);
        Floats const when = wait + now * (1 - 4 * unit);
        Integers const passes =
            (load_sixteen(candidates) == i) | (b >= slack * (r2 + v2)) | (disc < 0);
        // What is no number, for want of range, has to be looked at.
        Integers const ahead = (c > 0) & (when > 0);
        Floats const bound = ahead ? when : Floats{};
        Keys key;
        std::memcpy(&key, &bound, sizeof key);
        key = (key & ~(screen_lanes - 1)) | lane_numbers();
        return passes ? Keys{} + never : key;
    }

    /// The keys without that of one lane.
    static Keys without(Keys keys, std::int32_t lane) {
        return lane_numbers() == lane ? Keys{} + never : keys;
    }

    void fetch(std::int32_t ball) const { __builtin_prefetch(sketches_.data() + ball); }

    std::size_t bytes() const { return sketches_.capacity() * sizeof(Sketch); }

private:
    static constexpr float unit = 0x1p-24f; // roundoff
    static constexpr float slack = 32 * unit;

    static Floats root(Floats x) {
        Floats roots;
        for (int lane = 0; lane < screen_lanes; ++lane) roots[lane] = std::sqrt(x[lane]);
        return roots;
    }

    double per_diameter_, per_epoch_;
    float side_, inverse_side_;
    std::vector<Sketch> sketches_;
};

} // namespace clack
