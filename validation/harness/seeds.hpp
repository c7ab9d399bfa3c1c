#pragma once
// Which random numbers a replicate starts from: a function of what is measured, of nothing else.

#include <cstdint>
#include <string_view>

namespace clack::validation {

/// A hash of a text: FNV-1a over its bytes with a final avalanche, the same on every machine.
/// Source: G. Fowler, L. C. Noll, K.-P. Vo, draft-eastlake-fnv; the avalanche is splitmix64's
/// (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014, doi:10.1145/2660193.2660195).
std::uint64_t hash_of(std::string_view text);

/// The seed of one replicate of one state point of one experiment. Adding, removing or reordering
/// state points leaves the seeds of all others as they are. Fits a signed 64-bit integer, as the
/// scene file wants it.
std::uint64_t seed_of(std::string_view experiment, std::string_view state_point, int replicate);

} // namespace clack::validation
