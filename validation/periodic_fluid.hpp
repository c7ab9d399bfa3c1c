#pragma once
// The periodic fluid that the experiments on motion measure in.

#include "reference/equation_of_state.hpp"
#include "reference/finite_size.hpp"
#include "validation/harness/campaign.hpp"
#include "validation/harness/engine_maker.hpp"
#include "validation/harness/interval.hpp"
#include "validation/harness/seeds.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace clack::validation {

/// A periodic fluid at kT = mass = diameter = 1.
struct PeriodicFluid {
    double packing_fraction;
    std::int64_t count;

    double number_density() const { return packing_fraction * 6 / std::numbers::pi; }
    double side() const { return std::cbrt(static_cast<double>(count) / number_density()); }
    double volume() const { return static_cast<double>(count) / number_density(); }
    /// Collisions per ball and unit time.
    double collision_rate() const {
        return reference::collision_rate(
            reference::collisional_compressibility(number_density(), count),
            3 * static_cast<double>(count) - 3);
    }
    std::string text() const {
        return fmt::format("packing_fraction={} count={}", packing_fraction, count);
    }
    Scene scene(std::uint64_t const seed) const {
        Scene scene;
        scene.system.boundary = Boundary::periodic;
        scene.system.count = count;
        scene.system.side = side();
        scene.arrangement = Arrangement::random;
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
