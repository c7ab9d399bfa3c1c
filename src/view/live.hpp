#pragma once
// The engine at work.

#include "scenes/scene.hpp"
#include "simulation/engine.hpp"
#include "view/source.hpp"

#include <deque>

namespace clack::view {

class Live final : public Source {
public:
    /// Throws InputError as `make_start` does.
    explicit Live(Scene scene);

    System const& system() const override { return engine_->system(); }
    double time() const override { return equilibrated_ ? engine_->time() : 0; }
    double first_time() const override { return 0; }
    double last_time() const override { return infinity<double>; }

    /// First of all the scene's equilibration, at time 0.
    Progress advance(double until) override;
    void seek(double to) override;
    bool step() override;
    bool step_back() override;

    Snapshot snapshot() const override { return engine_->snapshot(); }
    Sample sample() const override;
    History const* history() const override { return &history_; }
    void trace(std::int64_t ball) override;
    Search search(std::optional<std::int64_t> ball) override;
    Eigen::Matrix3Xd const& start_places() const override { return start_places_; }
    std::string description() const override;
    double preparation_share() const override;

private:
    /// A state to go back to.
    struct Kept {
        double time;
        Checkpoint checkpoint;
        History history;
    };

    Stop work(Goal const& goal);
    void equilibrate();
    void begin();
    void keep();
    void go_back_to(Kept const& kept);
    template <class Before> Kept const& latest_kept(Before const& before) const;

    Scene scene_;
    std::unique_ptr<Engine> engine_;
    std::uint64_t equilibration_ = 0; // collisions
    bool equilibrated_ = false;
    std::uint64_t slice_ = 256; // events in about a hundredth of a second
    Eigen::Matrix3Xd start_places_;
    History history_;
    std::deque<Kept> kept_; // in the order of time, time 0 first
};

} // namespace clack::view
