#include "cli/standstill.hpp"

#include "state/errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace clack {

namespace {

constexpr double waits_max = 1e6;
/// Each ball of a large lattice has to come as far as its neighbour first.
constexpr double waits_of_each_max = 1e3;
/// Nor is a disk to be filled with frames in which nothing has happened for a thousand waits.
constexpr std::uint64_t frames_max = 100'000;
constexpr double waits_max_with_frames = 1e3;
constexpr double waits_of_each_with_frames = 10;

/// Mean time between two collisions of any balls of an ideal gas of this speed.
double mean_wait(System const& system, double kinetic_energy) {
    auto const count = static_cast<double>(system.count);
    double const speed = std::sqrt(2 * kinetic_energy / (system.mass * count));
    double const cross_section = std::numbers::pi * system.diameter * system.diameter;
    double const rate = std::numbers::sqrt2 * system.number_density() * cross_section * speed;
    return 1 / (rate * count / 2);
}

} // namespace

StandstillWatch::StandstillWatch(System const& system, double kinetic_energy, std::string source)
    : mean_wait_(mean_wait(system, kinetic_energy)), count_(static_cast<double>(system.count)),
      source_(std::move(source)) {}

void StandstillWatch::look(double time, std::uint64_t collisions, std::uint64_t frames) {
    if (collisions != last_collisions_ || time < last_time_) {
        last_time_ = time;
        last_collisions_ = collisions;
        last_frames_ = frames;
    }
    double const waits = (time - last_time_) / mean_wait_;
    double const of_each = waits / count_;
    bool const fills_disk = frames - last_frames_ > frames_max && waits > waits_max_with_frames &&
                            of_each > waits_of_each_with_frames;
    if (!(waits > waits_max && of_each > waits_of_each_max) && !fills_disk) return;
    throw InputError(fmt::format(
        "the goal counts collisions, and no balls have met from t = {:.6g} to {:.6g}: they seem "
        "never to; set time instead ({})",
        last_time_, time, source_));
}

} // namespace clack
