#pragma once
// The collisions to come, of all balls and of the one that is followed.

#include "view/frame.hpp"

#include <future>
#include <optional>

namespace clack::view {

class Foresight {
public:
    /// Puts into the frame what is known of the source's next collisions, and has the rest looked
    /// for. False while a search is under way.
    ///   tasks  what was asked of the source until now: with each the future may be another
    bool tell(Source& source, std::uint64_t tasks, Frame& frame);
    /// True when a search has just ended.
    bool has_news();

private:
    struct Found {
        double time = 0; // after which
        std::uint64_t tasks = 0;
        std::int64_t traced = -1;
        std::optional<NextCollision> next, next_of_traced;
    };

    Source::Search search(Source& source, std::optional<std::int64_t> ball,
                          std::optional<NextCollision> const& known) const;
    void begin(Source& source, Found const& wanted);

    std::future<Found> search_;
    Found found_; // the latest
    bool any_found_ = false;
};

} // namespace clack::view
