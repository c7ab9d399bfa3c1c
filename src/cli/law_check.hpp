#pragma once
// The laws recomputed from what a trajectory holds.

#include "io/trajectory_reader.hpp"
#include "observables/event_replay.hpp"

#include <string>
#include <vector>

namespace clack {

struct Verdict {
    std::string law;
    Departure departure;
};

/// Overlaps, places inside the cube, energy, momentum (periodic) and time of every frame, what the
/// file says of itself, and, where events are stored, their order, contacts and exchanges, and that
/// they lead from frame to frame. Bounds are those of the rounding of the run's numbers.
/// Throws InputError when the file holds no frame.
std::vector<Verdict> check_laws(TrajectoryReader const& file);

} // namespace clack
