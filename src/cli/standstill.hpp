#pragma once
// Tells a run that never reaches its number of collisions from one that takes long.

#include "state/system.hpp"

#include <cstdint>
#include <string>

namespace clack {

/// Balls on courses that never meet, all side by side for one, go on for ever without a collision,
/// and no finite look ahead can know. This watch gives up after a million of the times in which, on
/// average, one ball or another should have met its next, and a thousand of those a ball.
class StandstillWatch {
public:
    ///   kinetic_energy  of the run, which tells how fast its balls are
    ///   source          of the scene, for the message
    StandstillWatch(System const& system, double kinetic_energy, std::string source);

    /// Throws InputError when nothing has happened for so long.
    void look(double time, std::uint64_t collisions, std::uint64_t frames);

private:
    double mean_wait_; // [time]
    double count_;     // of balls
    std::string source_;
    double last_time_ = 0;
    std::uint64_t last_collisions_ = 0, last_frames_ = 0;
};

} // namespace clack
