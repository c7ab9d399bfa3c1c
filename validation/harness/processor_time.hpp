#pragma once
// How long something took, other processes aside.

#include <ctime>

namespace clack::validation {

/// Processor time of this thread so far.  [s]
inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace clack::validation
