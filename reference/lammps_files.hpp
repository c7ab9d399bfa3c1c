#pragma once
// The files that LAMMPS eats and leaves.

#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

namespace clack::reference {

/// Writes a start as a data file of atom_style sphere, ball i being atom i + 1, with all digits:
/// the first frame of a dump is the start to the last bit. Throws InputError when it cannot be
/// written.
void write_lammps_data(std::filesystem::path const& path, System const& system, Start const& start);

/// One frame of a dump: a row for each atom (dump custom) or entry (dump local).
struct DumpFrame {
    std::int64_t step = 0;
    std::vector<std::string> columns;
    Eigen::MatrixXd rows;

    /// Throws InputError for a column that the dump does not have.
    Eigen::VectorXd column(std::string const& name) const;
};

/// All frames of a text dump. Throws InputError, naming file and line, for one that is cut short or
/// holds what is no number.
std::vector<DumpFrame> read_lammps_dump(std::filesystem::path const& path);

/// The balls of a frame with the columns id x y z vx vy vz, sorted by id. Throws InputError unless
/// the ids are 1 ... count.
Start balls_of(DumpFrame const& frame);

/// A collision of two balls as frames see it: a pair that touches and did not in the frame before.
struct SeenCollision {
    std::int64_t step;
    std::int64_t first, second; // ball numbers, the lower one first
};

/// All collisions that frames of two columns, the ids of the pairs that touch, saw begin; in the
/// order of their steps, those of one step in the order of the numbers.
std::vector<SeenCollision> collisions_seen(std::vector<DumpFrame> const& frames);

/// The last row of a file of fix ave/time, without the step. Throws InputError when there is none.
std::vector<double> read_lammps_means(std::filesystem::path const& path);

} // namespace clack::reference
