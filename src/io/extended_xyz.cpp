#include "io/extended_xyz.hpp"

#include <fmt/format.h>

#include <iterator>

namespace clack {

void write_extended_xyz(std::ostream& out, System const& system, Snapshot const& frame) {
    char const wraps = system.boundary == Boundary::periodic ? 'T' : 'F';
    fmt::memory_buffer text;
    auto const end = std::back_inserter(text);
    fmt::format_to(end, "{}\n", frame.positions.cols());
    fmt::format_to(end,
                   "Lattice=\"{0:.17g} 0 0 0 {0:.17g} 0 0 0 {0:.17g}\" "
                   "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1 "
                   "pbc=\"{1} {1} {1}\" Time={2:.17g} Step={3}\n",
                   system.side, wraps, frame.time, frame.ball_collisions);
    for (Eigen::Index i = 0; i < frame.positions.cols(); ++i) {
        Eigen::Vector3d const place = frame.positions.col(i);
        Eigen::Vector3d const velocity = frame.velocities.col(i);
        fmt::format_to(end, "X {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {}\n",
                       place.x(), place.y(), place.z(), velocity.x(), velocity.y(), velocity.z(),
                       system.diameter / 2, i);
    }
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

} // namespace clack
