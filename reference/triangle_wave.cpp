#include "reference/triangle_wave.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace clack::reference {

TriangleWave::TriangleWave(double const length, double const start, double const velocity)
    : length_(length), start_(start), velocity_(velocity) {
    if (!(length > 0 && start >= 0 && start <= length)) {
        throw std::invalid_argument(
            fmt::format("start = {}: must lie between the mirrors at 0 and {}", start, length));
    }
}

long double TriangleWave::unfolded(double const time) const { return start_ + velocity_ * time; }

double TriangleWave::position(double const time) const {
    long double const period = 2 * length_;
    long double phase = std::fmod(unfolded(time), period);
    if (phase < 0) phase += period;
    return static_cast<double>(phase <= length_ ? phase : period - phase);
}

double TriangleWave::velocity(double const time) const {
    bool const turned = hits(time) % 2 != 0;
    return static_cast<double>(turned ? -velocity_ : velocity_);
}

std::int64_t TriangleWave::hits(double const time) const {
    return marks_passed(start_, velocity_ * time, length_);
}

std::int64_t marks_passed(long double const start, long double const path,
                          long double const spacing) {
    auto const rank = [&](long double const x) { return std::floor(x / spacing); };
    auto const rank_below = [&](long double const x) { return std::ceil(x / spacing); };
    long double const end = start + path;
    return static_cast<std::int64_t>(path >= 0 ? rank(end) - rank(start)
                                               : rank_below(start) - rank_below(end));
}

} // namespace clack::reference
