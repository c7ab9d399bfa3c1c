#pragma once
// The two kinds of error that reach a user. The third kind, a bug, is an assert.

#include <stdexcept>

namespace clack {

/// The user's mistake: one line that says what, where, the limit and what to do. Exit code 2.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A law of nature broken during a run: never repaired in silence. The line says enough to replay
/// it. Exit code 1.
struct LawBroken : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace clack
