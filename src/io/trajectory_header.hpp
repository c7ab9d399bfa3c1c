#pragma once
// What a trajectory file says once and for all: the scene, who ran it, and with what.

#include "io/hdf5.hpp"
#include "io/provenance.hpp"
#include "observables/horizon.hpp"
#include "scenes/scene.hpp"
#include "simulation/engine.hpp"
#include "state/system.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace clack {

struct TrajectoryHeader {
    std::string scene_text;   // as it was run, overrides written in
    std::string scene_source; // the name of the scene's file
    System system;
    Events events = Events::dropped;
    int limbs = 1;           // doubles in each number of a checkpoint
    double epoch_length = 1; // of the clock: an event's time is epoch * epoch_length + offset
    std::uint64_t seed = 0;
    ModelDescription model;
    std::optional<Horizon> horizon; // its time by theory: the file's head is written before the run
    Provenance provenance = own_provenance();
};

/// Writes the groups `h5md` and `parameters`.
void write_header(hdf5::Id const& file, TrajectoryHeader const& header);

/// Reads them back; the events and limbs of the header are told by the groups `events` and
/// `checkpoint`. Throws FileError when the file is not H5MD, not clack's or of another format;
/// `path` is for messages.
TrajectoryHeader read_header(hdf5::Id const& file, std::string const& path);

/// Throws FileError(not_h5md) unless the file calls itself H5MD.
void require_h5md(hdf5::Id const& file, std::string const& path);

} // namespace clack
