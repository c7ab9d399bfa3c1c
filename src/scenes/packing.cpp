#include "scenes/packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace clack {

namespace {

constexpr double ball_in_cube = std::numbers::pi / 6; // one ball that touches all six faces

/// A few roundings, so that balls which just touch still fit.
constexpr double slack = 1 + 8 * std::numeric_limits<double>::epsilon();

std::int64_t rounded_up_root(double count) {
    return static_cast<std::int64_t>(std::ceil(cube_root(count)));
}

/// Packing fraction of `count` balls in a cube of this side, in diameters.
double packing_fraction_at(std::int64_t count, double side) {
    return static_cast<double>(count) * ball_in_cube / (side * side * side);
}

/// Smallest side for a lattice arrangement, in diameters.
double smallest_lattice_side(Arrangement arrangement, Boundary boundary, std::int64_t count) {
    if (arrangement == Arrangement::grid) return static_cast<double>(grid_sites_per_side(count));
    double const layers = static_cast<double>(fcc_layers_per_side(boundary, count));
    if (boundary == Boundary::periodic) return layers / std::numbers::sqrt2;
    return (layers - 1 + std::numbers::sqrt2) / std::numbers::sqrt2;
}

/// At walls there is room that balls in disorder do not use: growing balls were seen to jam where
/// they fill this share of the cube without a layer at each wall, in diameters.
constexpr double jammed = 0.65, unused_layers = 2.0 / 6;

/// Largest packing fraction of a random arrangement. Between walls fewer than a hundred balls reach
/// anything from 0.25 to 0.5, by number: they are let grow until they jam.
double largest_random(Boundary boundary, std::int64_t count) {
    if (boundary == Boundary::periodic || count < 100) return densest_random;
    double const side =
        cube_root(static_cast<double>(count) * ball_in_cube / jammed) + unused_layers;
    return std::min(densest_random, packing_fraction_at(count, side));
}

/// Largest number of balls that the arrangement holds at this side, in diameters.
std::int64_t largest_count(Arrangement arrangement, Boundary boundary, double side) {
    if (side * slack < 1) return 0;
    double const room = side - unused_layers;
    auto const whole = [](double value) { return static_cast<std::int64_t>(value * slack); };
    switch (arrangement) {
    case Arrangement::grid:
        return whole(side) * whole(side) * whole(side);
    case Arrangement::fcc:
        return boundary == Boundary::periodic
                   ? fcc_site_count(2 * whole(side / std::numbers::sqrt2))
                   : fcc_site_count(whole((side - 1) * std::numbers::sqrt2) + 1);
    case Arrangement::random:
        return boundary == Boundary::periodic
                   ? whole(densest_random * side * side * side / ball_in_cube)
                   : std::min(whole(densest_random * side * side * side / ball_in_cube),
                              whole(jammed * room * room * room / ball_in_cube));
    default:
        return whole(close_packing * side * side * side / ball_in_cube);
    }
}

std::string arrangement_name(Arrangement arrangement) {
    switch (arrangement) {
    case Arrangement::grid:
        return "on a simple cubic grid";
    case Arrangement::fcc:
        return "in an fcc arrangement";
    case Arrangement::random:
        return "placed at random";
    default:
        return "in any arrangement";
    }
}

/// Four digits, rounded down, so that the number itself fits.
double rounded_down(double value) { return std::floor(value * 1e4) / 1e4; }

} // namespace

double cube_root(double value) {
    int exponent = 0;
    double const mantissa = std::frexp(value, &exponent); // [1/2, 1)
    int const remainder = ((exponent % 3) + 3) % 3;
    double const reduced = std::ldexp(mantissa, remainder); // [1/2, 4)
    double root = 0.68 + reduced * (0.36 - 0.04 * reduced); // within 8 %
    for (int step = 0; step < 5; ++step) // errors square: 8e-2, 6e-3, 4e-5, 2e-9, 1e-17, once more
        root -= (root * root * root - reduced) / (3 * root * root);
    return std::ldexp(root, (exponent - remainder) / 3);
}

double side_of_packing_fraction(std::int64_t count, double diameter, double packing_fraction) {
    return diameter * cube_root(static_cast<double>(count) * ball_in_cube / packing_fraction);
}

std::int64_t grid_sites_per_side(std::int64_t count) {
    std::int64_t sites = rounded_up_root(static_cast<double>(count));
    while (sites > 1 && (sites - 1) * (sites - 1) * (sites - 1) >= count) --sites;
    while (sites * sites * sites < count) ++sites;
    return sites;
}

std::int64_t fcc_site_count(std::int64_t layers) { return (layers * layers * layers + 1) / 2; }

std::int64_t fcc_layers_per_side(Boundary boundary, std::int64_t count) {
    if (boundary == Boundary::periodic) return 2 * grid_sites_per_side((count + 3) / 4);
    std::int64_t layers = grid_sites_per_side(2 * count);
    while (layers > 1 && fcc_site_count(layers - 1) >= count) --layers;
    return layers;
}

double fcc_layer_distance(System const& system, std::int64_t layers) {
    double const count = static_cast<double>(layers);
    return system.boundary == Boundary::periodic ? system.side / count
                                                 : system.side / (count - 1 + std::numbers::sqrt2);
}

double largest_packing_fraction(Arrangement arrangement, Boundary boundary, std::int64_t count) {
    double const any = count == 1 ? ball_in_cube : close_packing;
    switch (arrangement) {
    case Arrangement::grid:
    case Arrangement::fcc:
        return std::min(
            any, packing_fraction_at(count, smallest_lattice_side(arrangement, boundary, count)));
    case Arrangement::random:
        return std::min(any, largest_random(boundary, count));
    default:
        return any;
    }
}

std::string why_it_does_not_fit(System const& system, Arrangement arrangement, CubeGivenBy given) {
    double const largest = largest_packing_fraction(arrangement, system.boundary, system.count);
    double const packing_fraction = system.packing_fraction();
    if (packing_fraction <= largest * slack) return "";
    std::string const balls =
        fmt::format("{} ball{} {} {}", system.count, system.count == 1 ? "" : "s",
                    arrangement_name(arrangement),
                    system.boundary == Boundary::walls ? "between walls" : "with periodic images");
    if (given == CubeGivenBy::packing_fraction) {
        return fmt::format("{} fit up to {:.4f}; lower it or change count or arrangement", balls,
                           rounded_down(largest));
    }
    double const smallest = side_of_packing_fraction(system.count, system.diameter, largest);
    auto const fitting = largest_count(arrangement, system.boundary, system.side / system.diameter);
    return fmt::format("{} would have packing fraction {:.4g} and fit up to {:.4f}; raise side to "
                       "{:.6g} or {}",
                       balls, packing_fraction, rounded_down(largest), smallest * (1 + 1e-6),
                       fitting == 0 ? "lower the diameter"
                                    : fmt::format("take at most {} balls", fitting));
}

} // namespace clack
