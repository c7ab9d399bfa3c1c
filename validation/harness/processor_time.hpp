#pragma once
// How long something took, other processes aside.

#include <sys/resource.h>

#include <ctime>

namespace clack::validation {

/// Processor time of this thread so far.  [s]
inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Processor time of this program so far, and of the programs that it has run.  [s]
inline double processor_seconds_in_all() {
    double seconds = 0;
    for (auto const who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage used{};
        getrusage(who, &used);
        for (timeval const& part : {used.ru_utime, used.ru_stime})
            seconds += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
    }
    return seconds;
}

} // namespace clack::validation
