#pragma once
// Whether a run fits into memory, asked before any of it is taken.

#include "scenes/scene.hpp"

#include <cstddef>
#include <string>

namespace clack {

/// Bytes that this process can still take: what the system has available, within the limits set to
/// the process and its control group.
std::size_t available_bytes();

/// Bytes that a run of the scene takes: the engine's, the start, and what is kept back until it is
/// written.
std::size_t run_bytes(Scene const& scene);

/// Throws InputError, saying how much is needed and how much there is, when a scene does not fit,
/// with so many more bytes a ball for what looks on.
void require_memory(Scene const& scene, std::size_t bytes_beside = 0);

/// What is freed goes back to the system: the C library would come to keep arrays of up to 32 MiB,
/// 13 bytes a ball among a million of them.
void give_back_what_is_freed();

/// "12.3 MiB"
std::string bytes_in_words(double bytes);

} // namespace clack
