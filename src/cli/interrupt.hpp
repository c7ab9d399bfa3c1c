#pragma once
// SIGINT and SIGTERM: a run is asked to stop and closes its file; before it has one it just ends.

namespace clack {

constexpr int interrupted_exit_code = 130;

/// From now on a signal ends the process at once, with a line and that exit code: there is no file
/// yet to close.
void catch_interrupts();

/// From now on, which is before a file is begun, a signal only sets the flag that
/// `interrupt_requested` tells.
void defer_interrupts();
bool interrupt_requested();

} // namespace clack
