#include "cli/interrupt.hpp"

#include <unistd.h>

#include <csignal>

namespace clack {

namespace {

volatile std::sig_atomic_t requested = 0;
volatile std::sig_atomic_t deferred = 0;

// Only what a signal handler may do: write, _exit, set a flag.
void on_signal(int) {
    if (deferred) {
        requested = 1;
        return;
    }
    constexpr char line[] = "clack: interrupted before the run began; no file was written\n";
    [[maybe_unused]] auto const written = write(STDERR_FILENO, line, sizeof line - 1);
    _exit(interrupted_exit_code);
}

} // namespace

void catch_interrupts() {
    struct sigaction action = {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

void defer_interrupts() { deferred = 1; }

bool interrupt_requested() { return requested != 0; }

} // namespace clack
