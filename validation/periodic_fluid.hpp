#pragma once
// Balls in a periodic cube, in which the experiments on pressure, structure and motion measure.

#include "reference/crystal.hpp"
#include "reference/equation_of_state.hpp"
#include "reference/finite_size.hpp"
#include "validation/mutants/engine_maker.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace clack::validation {

/// A fluid, from random places, or a crystal, from an fcc lattice; kT = mass = diameter = 1.
struct PeriodicFluid {
    double packing_fraction;
    std::int64_t count;
    Arrangement arrangement = Arrangement::random;

    bool is_crystal() const { return arrangement == Arrangement::fcc; }
    double number_density() const { return packing_fraction * 6 / std::numbers::pi; }
    double volume() const { return static_cast<double>(count) / number_density(); }
    double side() const { return std::cbrt(volume()); }
    /// Compressibility factor that theory gives so many balls, and infinitely many.
    double expected() const {
        return is_crystal() ? reference::periodic_crystal(packing_fraction, count)
                            : reference::periodic_compressibility(number_density(), count);
    }
    double expected_of_infinitely_many() const {
        return is_crystal() ? reference::schultz_crystal(packing_fraction)
                            : reference::modified_klm(packing_fraction);
    }
    /// Its collisional part.
    double collisional() const { return expected() - 1 + 1 / static_cast<double>(count); }
    /// Collisions per ball and unit time: what turns collisions per ball into times.
    double collision_rate() const {
        if (!is_crystal() && packing_fraction > 0.54) // where only this still says something
            return 6 * std::numbers::inv_sqrtpi *
                   (reference::carnahan_starling(packing_fraction) - 1);
        return reference::collision_rate(collisional(), 3 * static_cast<double>(count) - 3);
    }
    std::string text() const {
        return fmt::format("packing_fraction={} count={}", packing_fraction, count);
    }
    Scene scene(std::uint64_t const seed) const {
        Scene scene;
        scene.system.boundary = Boundary::periodic;
        scene.system.count = count;
        scene.system.side = side();
        scene.arrangement = arrangement;
        scene.seed = seed;
        return scene;
    }
    /// An engine after so many collisions per ball, its clock at 0.
    std::unique_ptr<Engine> start(std::uint64_t const seed, double const equilibration,
                                  EngineMaker const& make) const {
        auto engine = make(scene(seed));
        engine->advance({.time = equilibration / collision_rate()});
        engine->start_clock();
        return engine;
    }
};

} // namespace clack::validation
