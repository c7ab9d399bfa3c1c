#pragma once
// How many balls fit into a cube, and how large the cube must be for a packing fraction.

#include "scenes/scene.hpp"

#include <cstdint>
#include <numbers>
#include <string>

namespace clack {

/// Densest packing of equal balls in space, pi / (3 sqrt 2) (Hales, Ann. Math. 162, 1065 (2005)).
constexpr double close_packing = std::numbers::pi / (3 * std::numbers::sqrt2);

/// What a random arrangement reaches with periodic boundaries; random close packing is at 0.64,
/// and growing balls crystallise or jam as they come near it.
constexpr double densest_random = 0.60;

/// Cube root of a positive number by a fixed number of + - * / only, so that it has the same bits
/// on every machine; within one unit in the last place.
double cube_root(double value);

/// Side of the cube in which `count` balls of `diameter` have this packing fraction.
double side_of_packing_fraction(std::int64_t count, double diameter, double packing_fraction);

/// Sites along one side of the simple cubic grid: the smallest m with m^3 >= count.
std::int64_t grid_sites_per_side(std::int64_t count);

/// Layers along one side of the fcc lattice, half a cubic cell apart: even with periodic
/// boundaries (4 balls a cell), any number between walls.
std::int64_t fcc_layers_per_side(Boundary boundary, std::int64_t count);
/// Sites of the fcc lattice with so many layers along each side, a site in the first corner.
std::int64_t fcc_site_count(std::int64_t layers);

/// Distance between fcc layers in a cube: periodic, they repeat after the side; between walls, the
/// gap that is left beside a wall is half of the gap between neighbouring balls.
double fcc_layer_distance(System const& system, std::int64_t layers);

/// Upper bound of the packing fraction for this many balls. For lattices it is reached, for
/// explicit places it is close packing, for random ones it is where growing balls were seen to jam.
double largest_packing_fraction(Arrangement arrangement, Boundary boundary, std::int64_t count);

/// Why the balls do not fit and what would, or nothing when they fit. `given` is what the user set.
enum class CubeGivenBy { side, packing_fraction };
std::string why_it_does_not_fit(System const& system, Arrangement arrangement, CubeGivenBy given);

} // namespace clack
