#pragma once
// Other processes: programs that print, and copies of this one for what may hang or crash.

#include "validation/statistics/estimate.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <system_error>

namespace clack::validation {

/// What a command prints; nothing when it cannot be run.
inline std::string output_of(std::string const& command) {
    std::unique_ptr<FILE, int (*)(FILE*)> const pipe(popen(command.c_str(), "r"), pclose);
    std::array<char, 4096> piece{};
    std::string output;
    while (pipe && std::fgets(piece.data(), piece.size(), pipe.get())) output += piece.data();
    return output;
}

enum class ChildEnd { finished, crashed, out_of_time };

struct ChildResult {
    ChildEnd end;
    Measurement values; // empty unless it finished
};

/// The child's part: never returns, and flushes nothing that the parent has yet to flush.
[[noreturn]] inline void work_and_tell(std::function<Measurement()> const& work, FILE* const file,
                                       unsigned const cpu_seconds) {
    rlimit const time{cpu_seconds, cpu_seconds + 1}, core{0, 0};
    setrlimit(RLIMIT_CPU, &time);
    setrlimit(RLIMIT_CORE, &core);
    for (int const deadly : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV})
        (void)std::signal(deadly, SIG_DFL); // not what the parent does about it
    bool told = false;
    try {
        Measurement const values = work();
        told = std::fwrite(values.data(), sizeof(double), values.size(), file) == values.size() &&
               std::fflush(file) == 0;
    } catch (...) { // a crash like any other, and no way back into the parent's program
        told = false;
    }
    _exit(told ? EXIT_SUCCESS : EXIT_FAILURE);
}

/// Does some work in a copy of this process and brings its numbers back, in a file that both have
/// open. A signal or an exception is a crash; processor time beyond the limit ends it.
inline ChildResult run_in_child(std::function<Measurement()> const& work,
                                unsigned const cpu_seconds) {
    std::unique_ptr<FILE, int (*)(FILE*)> const file(std::tmpfile(), std::fclose);
    pid_t const child = file ? fork() : -1;
    if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (child == 0) work_and_tell(work, file.get(), cpu_seconds);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
        return {ChildEnd::out_of_time, {}};
    if (!WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS) return {ChildEnd::crashed, {}};
    Measurement values;
    std::rewind(file.get());
    for (double value = 0; std::fread(&value, sizeof value, 1, file.get()) == 1;)
        values.push_back(value);
    return {ChildEnd::finished, values};
}

} // namespace clack::validation
