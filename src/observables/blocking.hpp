#pragma once
// The standard error of a rate whose successive values are correlated.

#include <optional>
#include <span>

namespace clack {

/// A measured value; without an error where the record is too short to give one.
struct Estimate {
    double value = 0;
    std::optional<double> error; // one standard error
};

/// Fewer blocks than this do not tell how far the error itself can be trusted (27 % with eight).
constexpr int block_count_min = 8;

/// The mean rate at which a quantity adds up, from its running sum at successive times.
/// Neighbouring intervals are merged in pairs, again and again (H. Flyvbjerg, H. G. Petersen,
/// J. Chem. Phys. 91, 461 (1989)); the error is that of the shortest blocks which no longer ones
/// exceed by more than the uncertainty of their own error, so that correlations have died out
/// within a block. Blocks of unequal duration are weighed as a ratio of sums.
///   times  rising                    [time]
///   sums   the running sum at each   [quantity]
/// Returns quantity / time; 0 without an error when no time passes, no error with fewer than
/// `block_count_min` blocks.
Estimate rate_by_blocking(std::span<double const> times, std::span<double const> sums);

} // namespace clack
