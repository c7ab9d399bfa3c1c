#pragma once
// How a scene's mistakes are worded: always one line.

#include "state/errors.hpp"

#include <string>

namespace clack {

/// An InputError whose message is one printable line, whatever a file's bytes brought into it.
inline InputError input_error(std::string message) {
    for (char& c : message)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    return InputError(message);
}

} // namespace clack
