#include "cli/commands.hpp"
#include "cli/law_check.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace clack {

int check_command(std::string const& path) {
    TrajectoryReader const file(path);
    auto const verdicts = check_laws(file);
    bool broken = false;
    for (auto const& verdict : verdicts) {
        broken |= verdict.departure.is_broken();
        fmt::print("{:<7} {}: {}\n", verdict.departure.is_broken() ? "BROKEN" : "ok", verdict.law,
                   verdict.departure.worst > 0
                       ? fmt::format("at most {:.2g} of the rounding bound{}",
                                     verdict.departure.worst,
                                     verdict.departure.is_broken() ? "; " + verdict.departure.where
                                                                   : std::string())
                       : std::string("exactly"));
    }
    fmt::print("{} frames and {} events checked: {}\n", file.frame_count(), file.event_count(),
               broken ? "a law is broken" : "all laws hold");
    return broken ? exit_law_broken : exit_done;
}

} // namespace clack
