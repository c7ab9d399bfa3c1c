#include "validation/harness/child_process.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <span>
#include <stdexcept>
#include <system_error>

namespace clack::validation {

namespace {

/// Repeats a system call that a signal interrupted.
template <class Call> ssize_t again(Call const& call) {
    ssize_t result = 0;
    do {
        result = call();
    } while (result < 0 && errno == EINTR);
    return result;
}

/// Whether all went through the pipe, which may take it in parts.
bool write_all(int const pipe, Measurement const& values) {
    auto const bytes = std::as_bytes(std::span(values));
    for (std::size_t done = 0; done < bytes.size();) {
        ssize_t const part =
            again([&] { return write(pipe, bytes.data() + done, bytes.size() - done); });
        if (part < 0) return false;
        done += static_cast<std::size_t>(part);
    }
    return true;
}

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
        if (write_all(pipe, work())) status = EXIT_SUCCESS;
    } catch (...) { // a crash like any other, and no way back into the parent's program
        status = EXIT_FAILURE;
    }
    _exit(status);
}

Measurement read_all(int const pipe) {
    std::vector<char> bytes;
    std::array<char, 4096> part{};
    for (ssize_t size = 0;
         (size = again([&] { return ::read(pipe, part.data(), part.size()); })) > 0;)
        bytes.insert(bytes.end(), part.begin(), part.begin() + size);
    Measurement values(bytes.size() / sizeof(double));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
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
    again([&] { return waitpid(child, &status, 0); });
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
        return {ChildEnd::out_of_time, {}};
    if (!WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS) return {ChildEnd::crashed, {}};
    return {ChildEnd::finished, values};
}

} // namespace clack::validation
