#pragma once
// Random numbers that are the same on every machine: std::mt19937_64 is fixed by the standard to
// the bit, its distributions are not.

#include <cstdint>
#include <random>

namespace clack {

using Generator = std::mt19937_64;

/// What the numbers are for: places and velocities of one seed do not share them.
enum class Stream : std::uint64_t { places = 1, velocities = 2 };

/// A generator for one purpose of one seed.
inline Generator make_generator(std::uint64_t seed, Stream stream) {
    // Finaliser of splitmix64 (Steele, Lea and Flood, OOPSLA 2014): close seeds end far apart.
    std::uint64_t mixed = seed + static_cast<std::uint64_t>(stream) * 0x9e3779b97f4a7c15u;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
    return Generator(mixed ^ (mixed >> 31));
}

/// Uniform in [0, 1): the upper 53 bits.
inline double uniform(Generator& generator) {
    return static_cast<double>(generator() >> 11) * 0x1p-53;
}

/// Uniform in [-1, 1).
inline double uniform_about_zero(Generator& generator) { return 2 * uniform(generator) - 1; }

} // namespace clack
