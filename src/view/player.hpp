#pragma once
// Plays a source on a thread of its own, so that the window always answers: it asks, and looks at
// the latest frame whenever it likes.

#include "view/foresight.hpp"
#include "view/frame.hpp"
#include "view/meter.hpp"
#include "view/physics.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace clack::view {

enum class Playing { no, yes };

/// An instant, and how the playing goes.
struct Shown {
    std::uint64_t number = 0;     // of the frame, rising
    std::uint64_t tasks_done = 0; // of those asked for, in their order
    Frame frame;
    Physics physics;
    Playing playing = Playing::no;
    double speed = 1;         // asked for: simulated time in a second
    Meter::Rates rates;       // as they were in the last half second
    bool settled = false;     // no collision to come is still being looked for
    double equilibration = 1; // share that is done; time stands still before
    double first_time = 0, last_time = 0;
    std::string description;
    std::string remark;  // on times between those that are known, empty if there is nothing to say
    std::string message; // what went wrong, empty if nothing
    std::string unforetold; // why no collision to come is told; empty if one is, or there is none
};

class Player {
public:
    using Maker = std::function<std::unique_ptr<Source>()>;

    explicit Player(std::unique_ptr<Source> source, double speed);
    Player(Player const&) = delete;
    Player& operator=(Player const&) = delete;
    ~Player();

    void play();
    void pause();
    void set_speed(double speed);
    void step();
    void step_back();
    void seek(double time);
    void trace(std::int64_t ball); // -1: none
    /// Another source in place of this one; if it cannot be made, this one stays, with a message.
    void restart(Maker maker);

    std::shared_ptr<Shown const> latest();
    /// Has a newer frame made, when there is something new. To make one copies all balls, which
    /// takes from the engine's time: not to be asked more often than frames are drawn.
    void want_news();
    std::uint64_t tasks_asked() const { return tasks_asked_; }
    /// Whether it shows all that has been asked for.
    bool has_done_all(Shown const& shown) const { return shown.tasks_done == tasks_asked_; }
    /// And all that follows from it.
    bool is_settled(Shown const& shown) const { return has_done_all(shown) && shown.settled; }

private:
    using Clock = std::chrono::steady_clock;
    using Task = std::function<void()>;

    void ask(Task task);
    void work();
    bool take_task();
    void guarded(Task const& task);
    void move();
    void refresh();
    void begin_anew();
    void keep_sample(Sample const& sample);
    Meter::Reached reached(Sample const& sample) const;
    void publish();
    std::string why_unforetold() const;

    // Of the thread alone.
    std::unique_ptr<Source> source_;
    std::shared_ptr<Eigen::Matrix3Xd const> start_places_;
    Shown now_; // without its frame
    Foresight foresight_;
    std::vector<Sample> samples_;
    Meter meter_;
    Clock::time_point last_move_, last_physics_, last_refresh_, last_sample_;
    double target_ = 0;
    bool arrived_ = true; // as near to the target as the source can come
    bool changed_ = true, asked_since_ = false, prepared_ = false;

    std::uint64_t tasks_asked_ = 0; // of those who ask

    // Shared.
    std::mutex mutex_;
    std::condition_variable asked_;
    std::deque<Task> tasks_;
    std::shared_ptr<Shown const> shown_;
    bool wanted_ = true, closing_ = false;
    std::thread thread_;
};

} // namespace clack::view
