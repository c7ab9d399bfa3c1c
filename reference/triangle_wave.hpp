#pragma once
// A point that moves freely between two mirrors: the one motion that every few-body check is
// built of.

#include <cstdint>

namespace clack::reference {

/// A point between mirrors at 0 and `length`: a triangle wave of period 2 length / |velocity|.
/// Computed from the start for any time, with an error of a few long double roundings of the path.
/// Source: method of images; exact.
class TriangleWave {
public:
    ///   start      at time 0, in [0, length]
    ///   velocity   at time 0
    /// Throws std::invalid_argument unless length > 0 and start lies between the mirrors.
    TriangleWave(double length, double start, double velocity);

    double position(double time) const;
    double velocity(double time) const; // after a hit, at the instant of one
    /// Hits of both mirrors in (0, time].
    std::int64_t hits(double time) const;

private:
    friend class GhostChain;
    long double unfolded(double time) const; // where the point would be without mirrors
    long double length_, start_, velocity_;
};

/// How many multiples of `spacing` a point passes that moves steadily from `start` by `path`:
/// those in (start, start + path], or in [start + path, start) when it moves down.
std::int64_t marks_passed(long double start, long double path, long double spacing);

} // namespace clack::reference
