#pragma once
// A hint to the memory.

namespace clack {

/// Asks for what will be read soon. To g++ 12 a function that does nothing else has no effect, and
/// calls of it are left out: the empty statement keeps them.
inline void prefetch(void const* address) {
    __builtin_prefetch(address);
    asm volatile("");
}

} // namespace clack
