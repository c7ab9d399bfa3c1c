#include "cli/progress.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace clack {

namespace {

constexpr double bar_seconds = 0.2, line_seconds = 10;
constexpr int bar_width = 24;

std::string bar(double done) {
    auto const full = static_cast<int>(done * bar_width);
    return fmt::format("[{:#>{}}{:.>{}}]", "", full, "", bar_width - full);
}

} // namespace

ProgressLine::ProgressLine(Progress progress)
    : style_(progress == Progress::hidden ? Style::nothing
             : isatty(STDERR_FILENO)      ? Style::bar
                                          : Style::lines) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::begin(std::string stage, double done, std::uint64_t collisions) {
    clear();
    stage_ = std::move(stage);
    first_done_ = done;
    first_collisions_ = collisions;
    begin_ = last_ = Clock::now();
}

void ProgressLine::show(double done, std::uint64_t collisions) {
    if (style_ == Style::nothing) return;
    auto const now = Clock::now();
    double const pause = style_ == Style::bar ? bar_seconds : line_seconds;
    if (std::chrono::duration<double>(now - last_).count() < pause) return;
    last_ = now;
    double const seconds = std::chrono::duration<double>(now - begin_).count();
    double const rate = static_cast<double>(collisions - first_collisions_) / seconds;
    double const left = seconds * (1 - done) / (done - first_done_);
    auto const text = fmt::format("{} {:5.1f} %, {:.3g} collisions/s, {} left", stage_, 100 * done,
                                  rate, std::isfinite(left) ? duration_in_words(left) : "?");
    if (style_ == Style::bar) {
        // Clearing to the end of the line wipes what a longer one left.
        fmt::print(stderr, "\r{} {}\x1b[K", bar(done), text);
        on_screen_ = true;
    } else {
        fmt::print(stderr, "{}\n", text);
    }
    std::fflush(stderr);
}

void ProgressLine::clear() {
    if (!std::exchange(on_screen_, false)) return;
    fmt::print(stderr, "\r\x1b[K");
    std::fflush(stderr);
}

std::string duration_in_words(double seconds) {
    if (seconds < 1) return "less than 1 s";
    if (!(seconds < 3.2e9)) return "more than a century";
    auto const whole = static_cast<long long>(std::lround(seconds));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
    if (whole < 86400) return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
    return fmt::format("{} d {} h", whole / 86400, whole % 86400 / 3600);
}

} // namespace clack
