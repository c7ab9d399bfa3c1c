#pragma once
// The laws that a run may never break: always checked, never repaired in silence.

#include "prediction/contact.hpp"
#include "state/checkpoint.hpp"
#include "state/clock.hpp"
#include "state/errors.hpp"
#include "state/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace clack {

template <class Real> class Laws {
public:
    Laws(System const& system, double epoch_length)
        : count_(static_cast<double>(system.count)),
          length_(static_cast<Real>(system.side + system.diameter)),
          epoch_length_(static_cast<Real>(epoch_length)),
          rounding_of_places_(2 * rounding_ * length_ * static_cast<Real>(system.diameter)),
          standstill_max_(100'000 + 1'000 * static_cast<std::uint64_t>(system.count)) {}

    /// Time never runs backwards, and does not stand still for ever: balls wedged between their
    /// neighbours collide without end at one moment.
    void time_goes_on(Clock<Real> const& clock, Real time) {
        if (!(time > clock.offset)) return time_stands_still(clock, time);
        standstill_ = 0;
    }
    [[gnu::noinline]] void time_stands_still(Clock<Real> const& clock, Real time) {
        if (time < clock.offset) {
            throw LawBroken(fmt::format("time ran backwards by {:.3g} at t = {:.17g}",
                                        static_cast<double>(clock.offset - time), clock.time()));
        }
        if (++standstill_ > standstill_max_) {
            throw LawBroken(
                fmt::format("{} events at t = {:.17g} and no end: the balls are jammed; "
                            "lower the packing fraction",
                            standstill_, clock.time()));
        }
    }

    /// Whether two balls that collide are a diameter apart beyond any question, which takes no
    /// root.
    bool near_contact(Real distance2, Real diameter2) const {
        using std::abs;
        return abs(distance2 - diameter2) <= rounding_of_places_;
    }

    /// Two balls that collide are a diameter apart, to the rounding of places and times.
    [[gnu::noinline]] void in_contact(Real distance2, Real diameter2, Pair<Real> const& pair,
                                      Clock<Real> const& clock, std::int32_t i, std::int32_t j,
                                      Tallies const& tallies) const {
        using std::abs;
        using std::sqrt;
        Real const off = distance2 - diameter2;
        Real const speed = sqrt(pair.vx * pair.vx + pair.vy * pair.vy + pair.vz * pair.vz);
        Real const allowed = 2 * rounding_ * (length_ + speed * epoch_length_) * sqrt(diameter2);
        if (abs(off) <= allowed) return;
        auto const depth = static_cast<double>((diameter2 - distance2) / (2 * diameter2));
        throw LawBroken(
            fmt::format("balls {} and {} {} by {:.3g} diameters at t = {:.17g} (collision {})", i,
                        j, depth > 0 ? "overlap" : "collide while apart", std::abs(depth),
                        clock.time(), tallies.ball_collisions));
    }

    /// Energy wanders by rounding alone: a few units for each collision of a ball at the very most.
    void energy_is_kept(Real energy, Clock<Real> const& clock, Tallies const& tallies) {
        if (first_energy_ < 0) {
            first_energy_ = energy;
            return;
        }
        using std::abs;
        auto const collisions =
            static_cast<double>(tallies.ball_collisions + tallies.wall_collisions) / count_;
        Real const bound =
            unit_roundoff<Real> * static_cast<Real>(1000 + 16 * collisions) * first_energy_;
        if (abs(energy - first_energy_) <= bound) return;
        throw LawBroken(
            fmt::format("energy drifted by {:.3g} of itself at t = {:.17g} (collision {})",
                        static_cast<double>((energy - first_energy_) / first_energy_), clock.time(),
                        tallies.ball_collisions));
    }

private:
    // The places of a start are doubles, whatever type they are moved in.
    Real const rounding_ =
        std::max<Real>(1024 * unit_roundoff<Real>, static_cast<Real>(16 * unit_roundoff<double>));
    double count_;
    Real length_, epoch_length_;
    Real rounding_of_places_; // in a squared distance
    Real first_energy_ = -1;
    std::uint64_t standstill_ = 0, standstill_max_;
};

} // namespace clack
