#pragma once
// When a run stores frames and takes samples, and when it ends. All of it follows from the scene,
// so that a resumed run goes on at the same moments.

#include "io/checkpoint_slots.hpp"
#include "observables/pressure.hpp"
#include "scenes/scene.hpp"
#include "simulation/engine.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace clack {

/// The moments of one scene. Frames come at whole multiples of the frame interval, so that no
/// rounding adds up. Samples come at multiples of a power of two, of time or of collisions,
/// whichever the goal counts, about 200 to 400 of them: a run with a larger goal takes some of the
/// same samples, so that an extended run keeps what one of that length would have.
class Schedule {
public:
    explicit Schedule(Scene const& scene);

    /// Collisions before time 0.
    std::uint64_t equilibration() const { return equilibration_; }

    double end_time() const { return end_time_; }
    std::uint64_t end_collisions() const { return end_collisions_; }
    double frame_time(std::uint64_t frame) const;
    double sample_time(std::uint64_t sample) const;
    std::uint64_t sample_collisions(std::uint64_t sample) const;

    /// What comes next, or ends the run.
    Goal next_goal(ResumePoint const& point) const;
    bool frame_is_due(ResumePoint const& point, Goal const& goal, Stop stop) const;
    bool sample_is_due(ResumePoint const& point, Goal const& goal, Stop stop) const;
    bool is_reached(double time, std::uint64_t ball_collisions) const;
    /// Whether two moments are one, but for the rounding of the run's clock.
    bool same_moment(double a, double b) const;
    /// How far a run is, in [0, 1].
    double progress(double time, std::uint64_t ball_collisions) const;

    /// Prepares a run that was made by the schedule `old` to go on by this one: what stands in the
    /// file only because the run had ended goes, and so do samples finer than this one's.
    void extend(Schedule const& old, ResumePoint& point, std::vector<Sample>& samples) const;

private:
    bool counts_time() const { return end_time_ < std::numeric_limits<double>::infinity(); }
    bool is_on_pace(Sample const& sample) const;

    std::uint64_t equilibration_ = 0;
    double end_time_ = std::numeric_limits<double>::infinity();
    std::uint64_t end_collisions_ = std::numeric_limits<std::uint64_t>::max();
    double frame_interval_ = 0;
    double rounding_ = 0; // of the clock, relative
    double pace_ = 0;     // of samples, a power of two  [time] or [collisions]
};

} // namespace clack
