#pragma once
// A trajectory, replayed: from frame to frame, and between frames exactly where the file holds its
// collisions.

#include "io/trajectory_reader.hpp"
#include "view/source.hpp"

#include <memory>
#include <vector>

namespace clack::view {

class Replay final : public Source {
public:
    /// Throws FileError, and InputError when the file holds no frame.
    explicit Replay(std::string const& path);

    System const& system() const override { return system_; }
    double time() const override { return time_; }
    double first_time() const override { return first_time_; }
    double last_time() const override { return last_time_; }

    Progress advance(double until) override;
    /// Without collisions in the file: to the last frame that is not later.
    void seek(double to) override;
    /// Without collisions in the file: from frame to frame.
    bool step() override;
    bool step_back() override;

    Snapshot snapshot() const override;
    Sample sample() const override;
    History const* history() const override { return &history_; }
    void trace(std::int64_t ball) override;
    Search search(std::optional<std::int64_t> ball) override;
    Eigen::Matrix3Xd const& start_places() const override { return start_places_; }
    std::string description() const override;
    std::string remark() const override;

    bool may_grow() const override { return growing_; }
    /// Opens the file anew.
    void refresh() override;

    bool has_events() const { return has_events_; }

private:
    void open();
    void show_frame(std::size_t frame);
    std::size_t frame_at(double time) const;
    std::size_t events_until(std::size_t frame) const;
    template <class Later> std::size_t last_frame_before(Later const& later) const;
    void fly_to(std::int64_t ball, double time);
    void take_event(Collision<double> event);
    Collision<double> const* event(std::size_t index);
    std::optional<NextCollision> next_collision(std::optional<std::int64_t> ball);
    void pass_frames();
    void rewind_to(std::size_t frame);
    Eigen::Vector3d wrapped(Eigen::Vector3d place) const;

    std::string path_;
    std::unique_ptr<TrajectoryReader> file_; // none while it cannot be opened anew
    System system_;
    bool growing_ = false, has_events_ = false;
    std::size_t frame_count_ = 0;
    double first_time_ = 0, last_time_ = 0;
    std::size_t frame_ = 0; // the last one not later than now
    Sample sample_;         // of that frame
    Tallies met_;           // collisions until now, where the file tells of each
    double time_ = 0;

    Snapshot flights_;                      // places and velocities as the last event left them
    std::vector<double> since_;             // when that was
    std::size_t next_event_ = 0;            // the first that is later than now
    std::vector<Collision<double>> window_; // events read at once
    std::size_t window_begin_ = 0;
    History history_;
    Eigen::Matrix3Xd start_places_;
};

} // namespace clack::view
