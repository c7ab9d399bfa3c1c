#pragma once
// How a cube is cut into cells, and in which of them a place lies.

#include "neighbours/cell_bins.hpp"
#include "state/ball.hpp"
#include "state/system.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace clack {

/// How a cube is cut into cells.
template <class Real> struct CellLattice {
    Real origin, side, inverse_side; // of a cell
    std::int32_t per_side;
    double finest; // cells across the cube, if they were as narrow as may be

    /// As many cells as the balls' number wants (`balls_per_cell` on average), never narrower than
    /// `width`, never fewer than `periodic_min` across a periodic cube.
    template <class Container>
    CellLattice(System const& system, Container const& cube, double width, double balls_per_cell,
                int periodic_min) {
        double const extent = static_cast<double>(cube.extent());
        double const wanted =
            std::cbrt(balls_per_cell / static_cast<double>(system.count)) * extent;
        double const cells = std::floor(extent / std::max(width, wanted));
        constexpr double cells_max = 1290; // their cube still fits 31 bits
        constexpr double cells_in_line_max = 0x1p17;
        int const least = Container::boundary == Boundary::periodic ? periodic_min : 1;
        per_side = std::max(least, static_cast<int>(std::min(cells, cells_max)));
        origin = cube.origin();
        finest = std::floor(std::min(extent / width, cells_in_line_max));
        set_cells(cube, per_side);
    }

    template <class Container> void set_cells(Container const& cube, std::int32_t cells) {
        per_side = cells;
        side = cube.extent() / static_cast<Real>(per_side);
        inverse_side = side > 0 ? 1 / side : Real(0);
    }

    /// A diameter, and what rounding can move a ball, so that none is met from two cells away.
    static double reach(System const& system) {
        double const unit = std::max(static_cast<double>(unit_roundoff<Real>), 0x1p-53);
        return system.diameter + 1024 * unit * (system.diameter + system.side);
    }

    Cell cell_at(Vector3<Real> const& place) const {
        Cell cell{};
        for (int d = 0; d < 3; ++d) {
            auto const raw = static_cast<std::int32_t>((place[d] - origin) * inverse_side);
            cell[static_cast<std::size_t>(d)] = std::clamp(raw, 0, per_side - 1);
        }
        return cell;
    }
};

} // namespace clack
