#pragma once
// All that a picture and the panels beside it show of one instant.

#include "view/source.hpp"

#include <memory>

namespace clack::view {

struct Frame {
    System system;
    Snapshot snapshot;
    Sample sample;
    std::vector<Past> pasts; // of each ball; empty where not known
    std::uint64_t total_collisions = 0;
    std::int64_t traced = -1;
    std::vector<Bend> path; // of the traced ball
    std::optional<NextCollision> next, next_of_traced;
    std::shared_ptr<Eigen::Matrix3Xd const> start_places;
};

/// What a source shows now, but for the collisions to come.
Frame frame_of(Source const& source, std::shared_ptr<Eigen::Matrix3Xd const> start_places);

} // namespace clack::view
