#pragma once
// A visit to the window by a script, one command a line: for demonstrations and tests.

#include "view/session.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace clack::view {

/// What a visit can do besides asking the session.
class Visited {
public:
    virtual ~Visited() = default;
    virtual void press(Key const& key) = 0;
    virtual void click(float x, float y) = 0;
    virtual void drag(float right, float down) = 0;
    virtual void scroll(float notches) = 0;
    /// Whether the window shows the latest frame.
    virtual bool is_up_to_date() const = 0;
    virtual void save(std::string const& path) = 0;
    /// The longest that the window was deaf since this was last asked  [s]
    virtual double longest_deafness() = 0;
    /// The longest that a picture took to show what was asked for, likewise  [s]
    virtual double longest_answer() = 0;
    virtual double drawing_seconds() const = 0;
};

class Visit {
public:
    /// Throws InputError with file, line and command when it is none.
    explicit Visit(std::string const& path);

    /// Does what is due now.
    void go_on(Session& session, Visited& window);

private:
    using Clock = std::chrono::steady_clock;

    struct Command {
        std::string name;
        std::vector<std::string> words;
    };

    bool is_done_waiting(Session const& session, Visited const& window) const;
    void perform(Command const& command, Session& session, Visited& window);
    void choose(Command const& command, Session& session) const;

    std::vector<Command> commands_;
    std::size_t next_ = 0;
    Clock::time_point wait_until_;
    double wait_for_time_ = -1; // of the balls
};

} // namespace clack::view
