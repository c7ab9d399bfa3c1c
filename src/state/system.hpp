#pragma once
// What never changes during a run: how many balls, how large, in what cube.

#include <cstdint>
#include <numbers>

namespace clack {

/// Hard walls that reflect, or a cube that repeats itself in space.
enum class Boundary { walls, periodic };

/// Equal hard balls in a cube. `side` is the physical side, wall to wall: with walls the centres
/// stay in [diameter / 2, side - diameter / 2], with periodic boundaries in [0, side].
struct System {
    Boundary boundary = Boundary::walls;
    double side = 1;        // [length]
    std::int64_t count = 0; // number of balls
    double diameter = 1;    // [length]
    double mass = 1;        // [mass]

    double volume() const { return side * side * side; }
    double number_density() const { return static_cast<double>(count) / volume(); }
    double packing_fraction() const {
        return number_density() * std::numbers::pi / 6 * diameter * diameter * diameter;
    }
    /// Side of the cube that the centres can reach.
    double accessible_side() const { return boundary == Boundary::walls ? side - diameter : side; }
    /// Velocity degrees of freedom of an equilibrium run: the total momentum of a periodic run is
    /// 0.
    double degrees_of_freedom() const {
        double const all = 3 * static_cast<double>(count);
        return boundary == Boundary::walls || count < 2 ? all : all - 3;
    }
};

/// A periodic box below four diameters: one ball may touch another through more than one image, and
/// no grid of cells tells them apart.
inline bool touches_through_several_images(System const& system) {
    return system.boundary == Boundary::periodic && system.side < 4.1 * system.diameter;
}

} // namespace clack
