#include "view/frame.hpp"

#include <utility>

namespace clack::view {

Frame frame_of(Source const& source, std::shared_ptr<Eigen::Matrix3Xd const> start_places) {
    Frame frame;
    frame.system = source.system();
    frame.snapshot = source.snapshot();
    frame.sample = source.sample();
    frame.start_places = std::move(start_places);
    if (History const* const history = source.history()) {
        frame.pasts = history->pasts();
        frame.total_collisions = history->total();
        frame.traced = history->traced();
        frame.path = history->path();
    }
    return frame;
}

} // namespace clack::view
