#include "cli/commands.hpp"
#include "io/extended_xyz.hpp"
#include "io/file_errors.hpp"
#include "io/output_file.hpp"
#include "io/trajectory_reader.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace clack {

namespace {

void write_frames(std::ostream& out, TrajectoryReader const& file, std::string const& name) {
    auto const fail = [&] {
        throw WriteError(name + ": cannot be written: " + std::strerror(errno ? errno : EIO));
    };
    errno = 0;
    for (std::size_t frame = 0; frame < file.frame_count() && out; ++frame) {
        write_extended_xyz(out, file.header().system, file.snapshot(frame));
    }
    if (!out.flush()) fail();
}

} // namespace

int export_command(ExportOptions const& options) {
    TrajectoryReader const file(options.trajectory);
    if (file.frame_count() == 0) {
        throw InputError(options.trajectory +
                         ": holds no frame yet, its run is still equilibrating; resume it first");
    }
    if (options.output == "-") {
        write_frames(std::cout, file, "standard output");
        return exit_done;
    }
    auto const output = real_path(
        options.output.empty() ? std::filesystem::path(options.trajectory).stem().string() + ".xyz"
                               : options.output);
    require_writable(output, Replacing::any_file);
    if (std::filesystem::exists(output) &&
        std::filesystem::equivalent(output, options.trajectory)) {
        throw InputError("output = " + output + ": is the trajectory itself; choose another name");
    }
    TemporaryName temporary(output);
    {
        std::ofstream out(temporary.name(), std::ios::binary);
        write_frames(out, file, output);
    }
    temporary.move_into_place();
    fmt::print("{} frames of {} balls in {}\n", file.frame_count(), file.header().system.count,
               output);
    return exit_done;
}

} // namespace clack
