#pragma once
// One number for a whole run: equal numbers, equal bits.

#include "resolution/collision.hpp"
#include "state/limbs.hpp"

#include <bit>
#include <cstdint>

namespace clack {

/// Hash of the collision sequence: of each collision its kind, its balls, the bits of its time
/// within the epoch and of the velocities it left. Each 64-bit word is mixed in by the multiply and
/// xor-shift of FNV and of splitmix (S. Vigna), so order matters.
class SequenceHash {
public:
    SequenceHash() = default;
    explicit SequenceHash(std::uint64_t value) : value_(value) {}

    std::uint64_t value() const { return value_; }

    template <class Real> void add(Collision<Real> const& collision) {
        mix(static_cast<std::uint64_t>(collision.kind));
        mix(static_cast<std::uint64_t>(collision.first));
        mix(static_cast<std::uint64_t>(collision.second));
        mix_bits(collision.offset);
        for (int d = 0; d < 3; ++d) mix_bits(collision.velocity_first[d]);
        for (int d = 0; d < 3; ++d) mix_bits(collision.velocity_second[d]);
    }

private:
    template <class Real> void mix_bits(Real x) {
        for (int limb = 0; limb < limb_count<Real>; ++limb) {
            auto const rounded = static_cast<double>(x);
            mix(std::bit_cast<std::uint64_t>(rounded));
            x -= static_cast<Real>(rounded);
        }
    }

    void mix(std::uint64_t word) {
        value_ = (value_ ^ word) * 0xBF58476D1CE4E5B9u;
        value_ ^= value_ >> 29;
    }

    std::uint64_t value_ = 0xCBF29CE484222325u;
};

} // namespace clack
