#pragma once
// Whether two trajectories hold the same run, bit for bit.

#include "io/trajectory_reader.hpp"

#include <cstring>
#include <string>

namespace clack::test {

inline bool same_bits(auto const& a, auto const& b) {
    return a.size() == b.size() &&
           std::memcmp(a.data(), b.data(),
                       sizeof(*a.data()) * static_cast<std::size_t>(a.size())) == 0;
}

inline bool same(Sample const& a, Sample const& b) {
    return a.time == b.time && a.kinetic_energy == b.kinetic_energy &&
           a.tallies.ball_collisions == b.tallies.ball_collisions &&
           a.tallies.wall_collisions == b.tallies.wall_collisions &&
           a.tallies.virial == b.tallies.virial &&
           a.tallies.wall_impulse == b.tallies.wall_impulse &&
           a.tallies.deepest_overlap == b.tallies.deepest_overlap;
}

inline bool same(Collision<double> const& a, Collision<double> const& b) {
    return a.kind == b.kind && a.epoch == b.epoch && a.offset == b.offset && a.time == b.time &&
           a.first == b.first && a.second == b.second && a.velocity_first == b.velocity_first &&
           a.velocity_second == b.velocity_second;
}

/// What differs first; empty when nothing does.
inline std::string difference(std::string const& path_a, std::string const& path_b) {
    TrajectoryReader const a(path_a), b(path_b);
    if (a.frame_count() != b.frame_count()) return "the number of frames";
    if (a.sample_count() != b.sample_count()) return "the number of samples";
    if (a.event_count() != b.event_count()) return "the number of events";
    for (std::size_t k = 0; k < a.frame_count(); ++k) {
        auto const frame_a = a.snapshot(k), frame_b = b.snapshot(k);
        if (frame_a.time != frame_b.time || frame_a.ball_collisions != frame_b.ball_collisions ||
            !same_bits(frame_a.positions, frame_b.positions) ||
            !same_bits(frame_a.velocities, frame_b.velocities) ||
            !same_bits(frame_a.images, frame_b.images) ||
            !same(a.frame_sample(k), b.frame_sample(k))) {
            return "frame " + std::to_string(k);
        }
    }
    auto const samples_a = a.samples(a.sample_count()), samples_b = b.samples(b.sample_count());
    for (std::size_t k = 0; k < samples_a.size(); ++k) {
        if (!same(samples_a[k], samples_b[k])) return "sample " + std::to_string(k);
    }
    auto const events_a = a.events(0, a.event_count()), events_b = b.events(0, b.event_count());
    for (std::size_t k = 0; k < events_a.size(); ++k) {
        if (!same(events_a[k], events_b[k])) return "event " + std::to_string(k);
    }
    auto const point_a = a.resume_point().engine, point_b = b.resume_point().engine;
    if (point_a.hash != point_b.hash) return "the hash";
    if (!same_bits(point_a.records, point_b.records)) return "the checkpoint";
    return "";
}

} // namespace clack::test
