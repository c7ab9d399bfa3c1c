#pragma once
// LAMMPS as a witness from outside: a program that is run, not a library, whose errors would end
// this process too.

#include "state/errors.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace clack::reference {

/// The one version that the decks are known to be right with: Debian 12's.
constexpr char const* lammps_version = "29 Sep 2021";

/// Why there are no results of LAMMPS.
enum class LammpsFailure {
    missing,          // no such program
    other_version,    // not `lammps_version`
    lost_atoms,       // balls left the cube or flew apart
    dangerous_builds, // neighbours came too late, so contacts may have been missed
    broke_off         // whatever else it says
};

/// One line that says what to do. An experiment ends with it; the others go on.
struct LammpsError : InputError {
    LammpsError(LammpsFailure why, std::string const& line) : InputError(line), failure(why) {}
    LammpsFailure failure;
};

/// One run of a deck: values for its variables. File names are relative to the folder of the run.
using LammpsJob = std::vector<std::pair<std::string, std::string>>;

/// The text of a deck that stands beside this file: "lammps_cube.in".
std::string lammps_deck(std::string const& file_name);

/// A folder for the files of LAMMPS that goes when this object does.
class LammpsFolder {
public:
    /// Throws InputError when no folder can be made.
    LammpsFolder();
    ~LammpsFolder();
    LammpsFolder(LammpsFolder const&) = delete;
    LammpsFolder& operator=(LammpsFolder const&) = delete;

    std::filesystem::path operator/(std::string const& name) const { return path_ / name; }
    std::filesystem::path const& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Runs jobs of one deck, one after the other in one process, since a start takes longer than most
/// of them. The program is `lmp`, or what the environment variable CLACK_LAMMPS names.
/// Throws LammpsError unless every job ran to its end with all its balls and no dangerous builds of
/// neighbour lists.
void run_lammps(LammpsFolder const& folder, std::string const& deck,
                std::vector<LammpsJob> const& jobs);

} // namespace clack::reference
