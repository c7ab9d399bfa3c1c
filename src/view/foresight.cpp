#include "view/foresight.hpp"

#include <chrono>
#include <exception>
#include <utility>

namespace clack::view {

bool Foresight::has_news() {
    if (!search_.valid() ||
        search_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout)
        return false;
    found_ = search_.get();
    any_found_ = true;
    return true;
}

/// What was found before holds until it has come about.
Source::Search Foresight::search(Source& source, std::optional<std::int64_t> ball,
                                 std::optional<NextCollision> const& known) const {
    if (known && known->time > source.time()) return [known] { return known; };
    return source.search(ball);
}

void Foresight::begin(Source& source, Found const& wanted) {
    bool const same = any_found_ && found_.tasks == wanted.tasks && found_.time <= wanted.time;
    auto of_all = search(source, std::nullopt, same ? found_.next : std::nullopt);
    Source::Search of_traced = [] { return std::nullopt; };
    if (wanted.traced >= 0) {
        bool const known = same && found_.traced == wanted.traced;
        of_traced = search(source, wanted.traced, known ? found_.next_of_traced : std::nullopt);
    }
    auto const policy =
        source.system().count <= few_balls ? std::launch::deferred : std::launch::async;
    search_ = std::async(policy, [found = wanted, of_all = std::move(of_all),
                                  of_traced = std::move(of_traced)]() mutable {
        try {
            found.next = of_all();
            found.next_of_traced = of_traced();
        } catch (std::exception const&) { // which the source will meet too, and report
        }
        return found;
    });
}

bool Foresight::tell(Source& source, std::uint64_t tasks, Frame& frame) {
    Found const wanted{source.time(), tasks, frame.traced, {}, {}};
    auto const holds = [&](std::optional<NextCollision> const& next) {
        return next ? next->time > wanted.time : found_.time == wanted.time;
    };
    auto const is_known = [&] {
        return any_found_ && found_.tasks == tasks && found_.traced == frame.traced &&
               found_.time <= wanted.time && holds(found_.next) &&
               (frame.traced < 0 || holds(found_.next_of_traced));
    };
    has_news();
    if (!is_known() && !search_.valid()) {
        begin(source, wanted);
        has_news();
    }
    if (!is_known()) return false; // a search is under way
    frame.next = found_.next;
    frame.next_of_traced = found_.next_of_traced;
    return true;
}

} // namespace clack::view
