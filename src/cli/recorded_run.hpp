#pragma once
// An engine at work with its file: the loop between a scene and its summary.

#include "cli/progress.hpp"
#include "cli/schedule.hpp"
#include "cli/standstill.hpp"
#include "io/trajectory_writer.hpp"
#include "scenes/scene.hpp"
#include "simulation/engine.hpp"

#include <chrono>
#include <memory>
#include <vector>

namespace clack {

/// A run from its start, or from where a file left it, to its goal. Equilibrates, makes that moment
/// time 0, and from then on stores frames, samples and, when asked, events, with a flush about
/// every two seconds. Stopping and going on changes nothing in what is stored.
class RecordedRun {
public:
    enum class End { finished, interrupted };

    RecordedRun(Scene const& scene, Engine& engine, TrajectoryWriter& writer, ProgressLine& line,
                ResumePoint point = {}, std::vector<Sample> samples = {});

    /// Returns with the file flushed, not closed. Throws LawBroken from the engine, WriteError from
    /// the file, and InputError when the goal counts collisions and none will ever happen.
    End run();

    std::vector<Sample> const& samples() const { return samples_; }
    double cpu_seconds() const { return point_.cpu_seconds; } // of the event loop since time 0

private:
    using Clock = std::chrono::steady_clock;

    /// Passes each collision on to the file.
    class EventRecorder final : public CollisionObserver {
    public:
        explicit EventRecorder(TrajectoryWriter& writer) : writer_(writer) {}
        void operator()(Collision<double> const& collision) override {
            writer_.add_event(collision);
        }

    private:
        TrajectoryWriter& writer_;
    };

    End equilibrate();
    void start_clock();
    End measure();
    Stop advance(Goal goal);
    void record(Goal const& goal, Stop stop);
    void finish();
    void add_frame();
    void add_sample();
    void flush();
    bool flush_is_due() const;
    bool frame_stands_here() const;
    Sample sample_now() const;

    Scene const& scene_;
    Schedule schedule_;
    Engine& engine_;
    TrajectoryWriter& writer_;
    ProgressLine& line_;
    ResumePoint point_;
    std::vector<Sample> samples_;
    EventRecorder recorder_;
    StandstillWatch watch_;
    double last_frame_time_ = -1;
    std::uint64_t slice_ = 256; // events between looks at the clock and at signals
    bool frame_is_new_ = false; // since the last flush
    Clock::time_point last_flush_;
    double flush_seconds_ = 0;
};

} // namespace clack
