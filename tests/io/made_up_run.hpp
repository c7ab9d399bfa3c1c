#pragma once
// Runs that no engine made: numbers that are easy to tell apart, for the tests of files.

#include "io/checkpoint_slots.hpp"
#include "io/trajectory_header.hpp"
#include "io/trajectory_writer.hpp"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace clack::test {

/// A folder of its own for each test program, gone at its end.
class Folder {
public:
    Folder()
        : path_(std::filesystem::temp_directory_path() /
                ("clack-test-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(path_);
    }
    Folder(Folder const&) = delete;
    Folder& operator=(Folder const&) = delete;
    ~Folder() { std::filesystem::remove_all(path_); }

    std::string file(std::string const& name) const { return (path_ / name).string(); }
    bool is_empty() const { return std::filesystem::is_empty(path_); }

private:
    std::filesystem::path path_;
};

inline TrajectoryHeader made_up_header(Boundary boundary, std::int64_t count,
                                       Events events = Events::stored, int limbs = 1) {
    TrajectoryHeader header;
    header.scene_text = "title = \"made up\"\n";
    header.scene_source = "made_up.toml";
    header.system = {boundary, 20.0, count, 1.0, 1.0};
    header.events = events;
    header.limbs = limbs;
    header.seed = 18446744073709551615u;
    header.model = {"walls", "cells", "heap", "double", "made up"};
    return header;
}

/// A number that is a third of an integer, so that every bit of its fraction is in use.
inline double distinct(std::int64_t a, std::int64_t b, std::int64_t c) {
    return static_cast<double>(1 + a + 7 * b + 1000 * c) / 3.0;
}

inline Snapshot made_up_frame(std::int64_t count, std::int64_t k) {
    Snapshot frame;
    frame.time = static_cast<double>(k) * 0.1;
    frame.ball_collisions = static_cast<std::uint64_t>(10 * k);
    frame.positions.resize(3, count);
    frame.velocities.resize(3, count);
    frame.images.resize(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            frame.positions(axis, i) = distinct(axis, i, k);
            frame.velocities(axis, i) = -distinct(axis, i, k + 1);
            frame.images(axis, i) = static_cast<int>(k - axis);
        }
    }
    return frame;
}

inline Sample made_up_sample(std::int64_t k) {
    auto const count = static_cast<std::uint64_t>(k);
    return {0.1 * static_cast<double>(k),
            {10 * count, 3 * count, distinct(1, k, 0), distinct(2, k, 0), 1e-15},
            distinct(3, k, 0)};
}

inline Collision<double> made_up_event(std::int64_t k) {
    Collision<double> event{};
    event.kind = k % 2 ? CollisionKind::wall : CollisionKind::ball;
    event.epoch = k;
    event.offset = distinct(0, k, 0);
    event.time = distinct(0, k, 0);
    event.first = k;
    event.second = k + 1;
    event.velocity_first = Eigen::Vector3d::Constant(distinct(1, k, 0));
    event.velocity_second = Eigen::Vector3d::Constant(distinct(2, k, 0));
    return event;
}

inline ResumePoint made_up_point(std::int64_t count, int limbs, std::int64_t k) {
    ResumePoint point;
    point.phase = Phase::under_way;
    point.cpu_seconds = distinct(0, 0, k);
    auto& engine = point.engine;
    engine.limbs = limbs;
    engine.epoch_length = 16;
    engine.epoch = k;
    engine.hash = 0xFEDCBA9876543210u + static_cast<std::uint64_t>(k);
    engine.tallies = {static_cast<std::uint64_t>(k), 2, distinct(1, 1, k), distinct(2, 1, k),
                      1e-15};
    for (int limb = 0; limb < limbs; ++limb)
        engine.offset.push_back(std::ldexp(1.0 / 3, -53 * limb));
    for (std::int64_t n = 0; n < count * 7 * limbs; ++n)
        engine.records.push_back(distinct(n, 0, k));
    engine.images = Eigen::Matrix3Xi::Constant(3, count, static_cast<int>(k));
    return point;
}

/// `frames` frames with one sample and one event each, a flush after every one.
inline void add_made_up(TrajectoryWriter& writer, std::int64_t count, int limbs, std::int64_t first,
                        std::int64_t frames) {
    for (std::int64_t k = first; k < first + frames; ++k) {
        writer.add_frame(made_up_frame(count, k), made_up_sample(k));
        writer.add_sample(made_up_sample(k));
        writer.add_event(made_up_event(k));
        auto point = made_up_point(count, limbs, k);
        writer.flush(point);
    }
}

inline void write_made_up_run(std::string const& path, TrajectoryHeader const& header,
                              std::int64_t frames) {
    TrajectoryWriter writer(path, header);
    auto start = made_up_point(header.system.count, header.limbs, 0);
    writer.flush(start);
    add_made_up(writer, header.system.count, header.limbs, 0, frames);
    writer.close();
}

} // namespace clack::test
