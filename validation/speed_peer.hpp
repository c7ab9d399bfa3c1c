#pragma once
// Another program beside clack's methods: whatever the environment variable CLACK_PEER names.
//
// It is called as
//     $CLACK_PEER N PACKING_FRACTION EQUILIBRATION RUN SEED
// with the number of balls, their packing fraction in a periodic cube, how many collisions per ball
// come first and how many are timed, and a seed. The last line that it prints is the number of
// collisions per second of processor time. One that cannot do a state point prints no number there.

#include "validation/child_process.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

namespace clack::validation::speed {

/// The command in the environment; empty when there is none.
inline std::string peer_of_environment() {
    char const* const command = std::getenv("CLACK_PEER");
    return command ? command : "";
}

/// The number on the last line of an output; NaN when there is none.
inline double last_number(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    std::size_t const begin = text.find_last_of('\n') + 1; // npos + 1 is 0
    char const* const end = text.data() + text.size();
    double number = 0;
    auto const [stopped, failure] = std::from_chars(text.data() + begin, end, number);
    bool const whole = failure == std::errc() && stopped == end;
    return whole ? number : std::numeric_limits<double>::quiet_NaN();
}

/// Processor time that the peer takes for a collision; NaN when it gives none.  [s]
inline double peer_seconds(std::string const& command, std::int64_t const count,
                           double const packing_fraction, double const equilibration,
                           std::uint64_t const collisions, std::uint64_t const seed) {
    double const per_ball = 2 * static_cast<double>(collisions) / static_cast<double>(count);
    std::string const call = fmt::format("{} {} {} {} {} {}", command, count, packing_fraction,
                                         equilibration, per_ball, seed % 1'000'000'007);
    double const rate = last_number(output_of(call));
    return rate > 0 ? 1 / rate : std::numeric_limits<double>::quiet_NaN();
}

} // namespace clack::validation::speed
