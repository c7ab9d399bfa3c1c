#include "io/checkpoint_slots.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace clack {

using hdf5::checked;
using hdf5::checked_status;
using hdf5::Id;

namespace {

constexpr int limbs_max = 3; // of a quad
constexpr std::array<char const*, 2> slot_names{"a", "b"};

/// A 64-bit sum over words in which every bit counts (multiply and fold, Knuth's odd constant).
class Checksum {
public:
    void add(void const* data, std::size_t bytes) {
        auto const* at = static_cast<unsigned char const*>(data);
        for (; bytes >= 8; at += 8, bytes -= 8) add_word(at, 8);
        if (bytes > 0) add_word(at, bytes);
    }
    std::uint64_t value() const { return state_; }

private:
    void add_word(unsigned char const* at, std::size_t bytes) {
        std::uint64_t word = 0;
        std::memcpy(&word, at, bytes);
        state_ = (state_ ^ word) * 0x9E3779B97F4A7C15u;
        state_ ^= state_ >> 29;
    }
    std::uint64_t state_ = 0xCBF29CE484222325u;
};

/// Fixed-size datasets laid out at once: overwriting one changes no metadata.
Id create_fixed(Id const& parent, char const* name, hid_t type, std::vector<hsize_t> const& sizes) {
    auto const rank = static_cast<int>(sizes.size());
    Id const space(
        checked(rank == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(rank, sizes.data(), nullptr),
                "make a dataspace"),
        H5Sclose);
    Id const list(checked(H5Pcreate(H5P_DATASET_CREATE), "prepare a checkpoint"), H5Pclose);
    checked_status(H5Pset_alloc_time(list.get(), H5D_ALLOC_TIME_EARLY), "prepare a checkpoint");
    checked_status(H5Pset_obj_track_times(list.get(), false), "prepare a checkpoint");
    return {checked(H5Dcreate2(parent.get(), name, type, space.get(), H5P_DEFAULT, list.get(),
                               H5P_DEFAULT),
                    "create a checkpoint"),
            H5Dclose};
}

void write_all(Id const& dataset, hid_t type, void const* data) {
    checked_status(H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data),
                   "write the checkpoint");
    checked_status(H5Dflush(dataset.get()), "write the checkpoint");
}

void read_all(Id const& dataset, hid_t type, void* data) {
    checked_status(H5Dread(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data),
                   "read the checkpoint");
}

} // namespace

/// Eight-byte fields only, so that there is no padding between them and the checksum may run over
/// the bytes.
struct CheckpointSlots::Header {
    std::uint64_t sequence, checksum;
    std::int64_t phase, limbs, epoch;
    double epoch_length, offset[limbs_max];
    std::uint64_t ball_collisions, wall_collisions;
    double virial, wall_impulse, deepest_overlap;
    std::uint64_t hash, frames, samples, events;
    std::uint64_t next_frame, next_sample, closing_frames, closing_samples;
    double cpu_seconds;
    std::uint64_t file_bytes;

    Header() { std::memset(static_cast<void*>(this), 0, sizeof(Header)); }

    Header(ResumePoint const& point, std::uint64_t new_sequence) : Header() {
        auto const& engine = point.engine;
        sequence = new_sequence;
        phase = static_cast<std::int64_t>(point.phase);
        limbs = engine.limbs;
        epoch = engine.epoch;
        epoch_length = engine.epoch_length;
        std::copy_n(engine.offset.begin(), engine.limbs, offset);
        ball_collisions = engine.tallies.ball_collisions;
        wall_collisions = engine.tallies.wall_collisions;
        virial = engine.tallies.virial;
        wall_impulse = engine.tallies.wall_impulse;
        deepest_overlap = engine.tallies.deepest_overlap;
        hash = engine.hash;
        frames = point.frames;
        samples = point.samples;
        events = point.events;
        next_frame = point.next_frame;
        next_sample = point.next_sample;
        closing_frames = point.closing_frames;
        closing_samples = point.closing_samples;
        cpu_seconds = point.cpu_seconds;
        file_bytes = point.file_bytes;
    }

    ResumePoint resume_point() const {
        ResumePoint point;
        point.phase = static_cast<Phase>(phase);
        point.frames = frames;
        point.samples = samples;
        point.events = events;
        point.next_frame = next_frame;
        point.next_sample = next_sample;
        point.closing_frames = closing_frames;
        point.closing_samples = closing_samples;
        point.cpu_seconds = cpu_seconds;
        point.file_bytes = file_bytes;
        auto& engine = point.engine;
        engine.limbs = static_cast<int>(limbs);
        engine.epoch = epoch;
        engine.epoch_length = epoch_length;
        engine.offset.assign(offset, offset + limbs);
        engine.tallies = {ball_collisions, wall_collisions, virial, wall_impulse, deepest_overlap};
        engine.hash = hash;
        return point;
    }

    /// Over this header without its own checksum, and the numbers it vouches for.
    std::uint64_t sum(Checkpoint const& engine) const {
        Header bare = *this;
        bare.checksum = 0;
        Checksum sum;
        sum.add(&bare, sizeof bare);
        sum.add(engine.records.data(), engine.records.size() * sizeof(double));
        sum.add(engine.images.data(),
                static_cast<std::size_t>(engine.images.size()) * sizeof(std::int32_t));
        return sum.value();
    }
};

Id CheckpointSlots::header_type() {
    hsize_t const offsets = limbs_max;
    Id const offset_type(
        checked(H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &offsets), "describe a checkpoint"),
        H5Tclose);
    hid_t const count = H5T_NATIVE_UINT64, number = H5T_NATIVE_INT64, real = H5T_NATIVE_DOUBLE;
    struct Member {
        char const* name;
        std::size_t offset;
        hid_t type;
    };
    Member const members[]{{"sequence", offsetof(Header, sequence), count},
                           {"checksum", offsetof(Header, checksum), count},
                           {"phase", offsetof(Header, phase), number},
                           {"limbs", offsetof(Header, limbs), number},
                           {"epoch", offsetof(Header, epoch), number},
                           {"epoch_length", offsetof(Header, epoch_length), real},
                           {"offset", offsetof(Header, offset), offset_type.get()},
                           {"ball_collisions", offsetof(Header, ball_collisions), count},
                           {"wall_collisions", offsetof(Header, wall_collisions), count},
                           {"virial", offsetof(Header, virial), real},
                           {"wall_impulse", offsetof(Header, wall_impulse), real},
                           {"deepest_overlap", offsetof(Header, deepest_overlap), real},
                           {"hash", offsetof(Header, hash), count},
                           {"frames", offsetof(Header, frames), count},
                           {"samples", offsetof(Header, samples), count},
                           {"events", offsetof(Header, events), count},
                           {"next_frame", offsetof(Header, next_frame), count},
                           {"next_sample", offsetof(Header, next_sample), count},
                           {"closing_frames", offsetof(Header, closing_frames), count},
                           {"closing_samples", offsetof(Header, closing_samples), count},
                           {"cpu_seconds", offsetof(Header, cpu_seconds), real},
                           {"file_bytes", offsetof(Header, file_bytes), count}};
    Id type(checked(H5Tcreate(H5T_COMPOUND, sizeof(Header)), "describe a checkpoint"), H5Tclose);
    for (auto const& member : members) {
        checked_status(H5Tinsert(type.get(), member.name, member.offset, member.type),
                       "describe a checkpoint");
    }
    return type;
}

CheckpointSlots CheckpointSlots::create(Id const& file, System const& system, int limbs) {
    static_assert(sizeof(Header) == 192);
    CheckpointSlots slots;
    auto const group = hdf5::create_group(file, "checkpoint");
    auto const balls = static_cast<hsize_t>(system.count);
    auto const numbers = 7 * static_cast<hsize_t>(limbs);
    for (std::size_t k = 0; k < slot_names.size(); ++k) {
        auto const parent = hdf5::create_group(group, slot_names[k]);
        auto& slot = slots.slots_[k];
        slot.header = create_fixed(parent, "header", header_type().get(), {});
        slot.records = create_fixed(parent, "records", H5T_NATIVE_DOUBLE, {balls, numbers});
        slot.images = create_fixed(parent, "images", H5T_NATIVE_INT32, {balls, 3});
        Header const not_written_yet;
        write_all(slot.header, header_type().get(), &not_written_yet);
    }
    return slots;
}

CheckpointSlots CheckpointSlots::open(Id const& file) {
    CheckpointSlots slots;
    auto const group = hdf5::open_group(file, "checkpoint");
    for (std::size_t k = 0; k < slot_names.size(); ++k) {
        auto const parent = hdf5::open_group(group, slot_names[k]);
        slots.slots_[k] = {hdf5::open_dataset(parent, "header"),
                           hdf5::open_dataset(parent, "records"),
                           hdf5::open_dataset(parent, "images")};
    }
    return slots;
}

void CheckpointSlots::write(ResumePoint const& point) {
    auto const& slot = slots_[next_sequence_ % slots_.size()];
    write_all(slot.records, H5T_NATIVE_DOUBLE, point.engine.records.data());
    write_all(slot.images, H5T_NATIVE_INT32, point.engine.images.data());
    Header header(point, next_sequence_);
    header.checksum = header.sum(point.engine);
    write_all(slot.header, header_type().get(), &header);
    ++next_sequence_;
}

std::optional<ResumePoint> CheckpointSlots::read() const {
    auto first = read(slots_[0]);
    auto second = read(slots_[1]);
    if (!first || (second && second->first > first->first)) std::swap(first, second);
    if (!first) return std::nullopt;
    return std::move(first->second);
}

std::optional<std::pair<std::uint64_t, ResumePoint>> CheckpointSlots::read(Slot const& slot) const {
    Header header;
    read_all(slot.header, header_type().get(), &header);
    if (header.sequence == 0 || header.limbs < 1 || header.limbs > limbs_max) return std::nullopt;
    auto point = header.resume_point();
    auto const sizes = hdf5::shape(slot.records);
    if (sizes.size() != 2 || sizes[1] != 7 * static_cast<hsize_t>(header.limbs)) {
        return std::nullopt;
    }
    point.engine.records.resize(static_cast<std::size_t>(sizes[0] * sizes[1]));
    point.engine.images.resize(3, static_cast<Eigen::Index>(sizes[0]));
    read_all(slot.records, H5T_NATIVE_DOUBLE, point.engine.records.data());
    read_all(slot.images, H5T_NATIVE_INT32, point.engine.images.data());
    if (header.checksum != header.sum(point.engine)) return std::nullopt;
    return std::pair{header.sequence, std::move(point)};
}

} // namespace clack
