#include "io/trajectory_header.hpp"

#include "io/file_errors.hpp"
#include "io/hdf5_attributes.hpp"
#include "io/layout.hpp"

#include <pwd.h>
#include <unistd.h>

#include <array>
#include <charconv>

namespace clack {

namespace {

constexpr char const* creator_name = "clack";

/// H5MD asks for a person; the name of the account is the best there is.
std::string author() {
    passwd const* const account = getpwuid(geteuid());
    if (!account) return "unknown";
    std::string const full = account->pw_gecos ? account->pw_gecos : "";
    std::string const name = full.substr(0, full.find(','));
    return name.empty() ? account->pw_name : name;
}

/// The texts of the provenance and where each stands; one list for writing and reading.
auto provenance_texts(auto& header) {
    using Entry = std::pair<char const*, decltype(&header.scene_text)>;
    return std::array<Entry, 10>{{{"version", &header.provenance.version},
                                  {"commit", &header.provenance.commit},
                                  {"compiler", &header.provenance.compiler},
                                  {"flags", &header.provenance.flags},
                                  {"machine", &header.provenance.machine},
                                  {"boundary", &header.model.boundary},
                                  {"search", &header.model.search},
                                  {"queue", &header.model.queue},
                                  {"precision", &header.model.precision},
                                  {"reason", &header.model.reason}}};
}

/// A group of its own with three numbers; files of earlier versions have none.
void write_horizon(hdf5::Id const& parameters, Horizon const& horizon) {
    auto const group = hdf5::create_group(parameters, "horizon");
    hdf5::write_attribute(group, "position_error_in_diameters", horizon.error);
    hdf5::write_attribute(group, "collisions_per_ball", horizon.collisions_per_ball);
    hdf5::write_attribute(group, "time", horizon.time);
    hdf5::write_attribute(group, "meaning",
                          std::string("positions hold to this error until then; beyond, only "
                                      "statistics hold"));
}

std::optional<Horizon> read_horizon(hdf5::Id const& parameters) {
    if (!hdf5::exists(parameters, "horizon")) return std::nullopt;
    auto const group = hdf5::open_group(parameters, "horizon");
    return Horizon{hdf5::read_double_attribute(group, "position_error_in_diameters"),
                   hdf5::read_double_attribute(group, "collisions_per_ball"),
                   hdf5::read_double_attribute(group, "time")};
}

int format_of(hdf5::Id const& parameters) {
    if (!hdf5::has_attribute(parameters, "format")) return 0;
    auto const values = hdf5::read_int_attribute(parameters, "format");
    return values.empty() ? 0 : values.front();
}

System read_system(hdf5::Id const& parameters, hdf5::Id const& balls) {
    System system;
    auto const boundary = hdf5::read_text_attributes(hdf5::open_group(balls, "box"), "boundary");
    system.boundary = boundary.at(0) == "periodic" ? Boundary::periodic : Boundary::walls;
    system.side = hdf5::read_double_attribute(parameters, "side");
    system.count =
        static_cast<std::int64_t>(hdf5::shape(hdf5::open_dataset(balls, "position/value")).at(1));
    system.diameter = hdf5::read_double_attribute(parameters, "diameter");
    system.mass = hdf5::read_double_attribute(parameters, "mass");
    return system;
}

} // namespace

void write_header(hdf5::Id const& file, TrajectoryHeader const& header) {
    auto const h5md = hdf5::create_group(file, "h5md");
    hdf5::write_attribute(h5md, "version", std::vector<int>{1, 1});
    hdf5::write_attribute(hdf5::create_group(h5md, "author"), "name", author());
    auto const creator = hdf5::create_group(h5md, "creator");
    hdf5::write_attribute(creator, "name", std::string(creator_name));
    hdf5::write_attribute(creator, "version", header.provenance.version);

    auto const parameters = hdf5::create_group(file, "parameters");
    hdf5::write_attribute(parameters, "format", std::vector<int>{file_format});
    hdf5::write_attribute(parameters, "side", header.system.side);
    hdf5::write_attribute(parameters, "diameter", header.system.diameter);
    hdf5::write_attribute(parameters, "mass", header.system.mass);
    hdf5::write_attribute(parameters, "epoch_length", header.epoch_length);
    hdf5::write_text(parameters, "scene", header.scene_text);
    hdf5::write_text(parameters, "scene_source", header.scene_source);

    if (header.horizon) write_horizon(parameters, *header.horizon);

    auto const provenance = hdf5::create_group(parameters, "provenance");
    for (auto const& [name, text] : provenance_texts(header)) {
        hdf5::write_attribute(provenance, name, *text);
    }
    // As a text: a seed may not fit the integers that other languages read.
    hdf5::write_attribute(provenance, "seed", std::to_string(header.seed));
}

void require_h5md(hdf5::Id const& file, std::string const& path) {
    if (!hdf5::exists(file, "h5md") || !hdf5::exists(file, "particles") ||
        !hdf5::has_attribute(hdf5::open_group(file, "h5md"), "version")) {
        throw FileError(FileFault::not_h5md,
                        path + ": is HDF5 but not H5MD: it has no h5md and particles groups; "
                               "give a trajectory");
    }
}

TrajectoryHeader read_header(hdf5::Id const& file, std::string const& path) {
    require_h5md(file, path);
    bool const has_creator = hdf5::exists(file, "h5md/creator");
    auto const name =
        has_creator ? hdf5::read_text_attribute(hdf5::open_group(file, "h5md/creator"), "name")
                    : std::string("an unnamed program");
    if (name != creator_name || !hdf5::exists(file, "parameters")) {
        throw FileError(FileFault::not_clack, path + ": was written by " + name +
                                                  ", not by clack; only clack's own files can be "
                                                  "used here");
    }
    auto const parameters = hdf5::open_group(file, "parameters");
    if (int const format = format_of(parameters); format != file_format) {
        auto const version =
            hdf5::read_text_attribute(hdf5::open_group(file, "h5md/creator"), "version");
        throw FileError(FileFault::other_version,
                        path + ": format = " + std::to_string(format) + " of clack " + version +
                            ": this clack, " + own_provenance().version + ", reads format " +
                            std::to_string(file_format) + "; use that version");
    }
    TrajectoryHeader header;
    header.scene_text = hdf5::read_text(parameters, "scene");
    header.scene_source = hdf5::read_text(parameters, "scene_source");
    header.system = read_system(parameters, hdf5::open_group(file, "particles/balls"));
    header.horizon = read_horizon(parameters);
    header.epoch_length = hdf5::read_double_attribute(parameters, "epoch_length");
    header.events = hdf5::exists(file, "events") ? Events::stored : Events::dropped;
    header.limbs =
        static_cast<int>(hdf5::shape(hdf5::open_dataset(file, "checkpoint/a/records")).at(1) / 7);

    auto const provenance = hdf5::open_group(parameters, "provenance");
    for (auto const& [text_name, text] : provenance_texts(header)) {
        *text = hdf5::read_text_attribute(provenance, text_name);
    }
    auto const seed = hdf5::read_text_attribute(provenance, "seed");
    std::from_chars(seed.data(), seed.data() + seed.size(), header.seed);
    return header;
}

} // namespace clack
