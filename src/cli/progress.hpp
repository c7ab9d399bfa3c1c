#pragma once
// How far a run is, for whoever waits: on standard error, so that standard output is the result's.

#include <chrono>
#include <cstdint>
#include <string>

namespace clack {

enum class Progress { shown, hidden };

/// A bar that rewrites its line on a terminal, a plain line every ten seconds elsewhere.
class ProgressLine {
public:
    explicit ProgressLine(Progress progress);
    ~ProgressLine();
    ProgressLine(ProgressLine const&) = delete;
    ProgressLine& operator=(ProgressLine const&) = delete;

    /// Begins to measure the rate and the time left anew.
    ///   stage  "equilibrating" or "running"
    ///   done   share done at this moment, in [0, 1]
    void begin(std::string stage, double done, std::uint64_t collisions);
    void show(double done, std::uint64_t collisions);
    /// Takes the bar off the terminal.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    enum class Style { bar, lines, nothing };
    Style style_;
    std::string stage_;
    double first_done_ = 0;
    std::uint64_t first_collisions_ = 0;
    Clock::time_point begin_, last_;
    bool on_screen_ = false;
};

/// "3 s", "4 min 10 s", "2 h 5 min", "3 d 4 h"
std::string duration_in_words(double seconds);

} // namespace clack
