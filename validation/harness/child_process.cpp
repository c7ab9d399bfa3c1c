#include "validation/harness/child_process.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace clack::validation {

namespace {

/// The child's part: never returns, and flushes nothing that the parent has yet to flush.
[[noreturn]] void work_and_tell(std::function<Measurement()> const& work, int const pipe,
                                unsigned const cpu_seconds) {
    rlimit const time{cpu_seconds, cpu_seconds + 1}, core{0, 0};
    setrlimit(RLIMIT_CPU, &time);
    setrlimit(RLIMIT_CORE, &core);
    for (int const deadly : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV})
        (void)std::signal(deadly, SIG_DFL); // not what the parent does about it
    int status = EXIT_FAILURE;
    try {
        Measurement const values = work();
        std::size_t const bytes = values.size() * sizeof(double);
        if (write(pipe, values.data(), bytes) == static_cast<ssize_t>(bytes)) status = EXIT_SUCCESS;
    } catch (...) { // a crash like any other, and no way back into the parent's program
        status = EXIT_FAILURE;
    }
    _exit(status);
}

Measurement read_all(int const pipe) {
    Measurement values;
    double value = 0;
    while (::read(pipe, &value, sizeof value) == static_cast<ssize_t>(sizeof value))
        values.push_back(value);
    return values;
}

} // namespace

ChildResult run_in_child(std::function<Measurement()> const& work, unsigned const cpu_seconds) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    pid_t const child = fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (child == 0) {
        close(ends[0]);
        work_and_tell(work, ends[1], cpu_seconds);
    }
    close(ends[1]);
    Measurement const values = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
        return {ChildEnd::out_of_time, {}};
    if (!WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS) return {ChildEnd::crashed, {}};
    return {ChildEnd::finished, values};
}

} // namespace clack::validation
