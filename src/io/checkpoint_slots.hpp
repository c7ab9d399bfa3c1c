#pragma once
// Where a run can go on: two slots in the file, written in turn, so that a process killed in the
// middle of one leaves the other whole.

#include "io/hdf5.hpp"
#include "state/checkpoint.hpp"
#include "state/system.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace clack {

/// A run equilibrates before its time 0, is under way after it, and then has reached its goal.
enum class Phase : std::int32_t { equilibrating = 0, under_way = 1, finished = 2 };

/// The state of a whole run: the engine's, and how much of the file belongs to it.
struct ResumePoint {
    Checkpoint engine;
    Phase phase = Phase::equilibrating;
    std::uint64_t frames = 0; // rows that are this run's up to here; later ones are redone
    std::uint64_t samples = 0;
    std::uint64_t events = 0;
    std::uint64_t next_frame = 0;      // the multiple of the frame interval that comes next
    std::uint64_t next_sample = 0;     // the multiple of the samples' pace that comes next
    std::uint64_t closing_frames = 0;  // 1 when the last frame stands there only because the run
    std::uint64_t closing_samples = 0; // ended then, and goes when it is extended; same for samples
    double cpu_seconds = 0;            // of the event loop since time 0
    std::uint64_t file_bytes = 0;      // the file's length by then: a shorter file has lost its end
};

/// The group `checkpoint` of a file: slots `a` and `b`, each with its numbers and a header that is
/// written last and carries a checksum over all.
class CheckpointSlots {
public:
    static CheckpointSlots create(hdf5::Id const& file, System const& system, int limbs);
    static CheckpointSlots open(hdf5::Id const& file);

    /// Overwrites the older slot and hands it to the system.
    void write(ResumePoint const& point);
    /// The newest slot that is whole; none when neither is.
    std::optional<ResumePoint> read() const;

private:
    struct Header;
    struct Slot {
        hdf5::Id header, records, images;
    };

    static hdf5::Id header_type();
    std::optional<std::pair<std::uint64_t, ResumePoint>> read(Slot const& slot) const;

    std::array<Slot, 2> slots_;
    std::uint64_t next_sequence_ = 1;
};

} // namespace clack
