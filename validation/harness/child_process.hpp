#pragma once
// What may hang or crash is measured in a process of its own.

#include "validation/harness/campaign.hpp"

#include <functional>

namespace clack::validation {

enum class ChildEnd { finished, crashed, out_of_time };

struct ChildResult {
    ChildEnd end;
    Measurement values; // empty unless it finished
};

/// Does some work in a copy of this process and brings its numbers back. A signal or an exception
/// is a crash; processor time beyond the limit ends it.
ChildResult run_in_child(std::function<Measurement()> const& work, unsigned cpu_seconds);

} // namespace clack::validation
