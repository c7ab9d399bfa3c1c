#include "validation/mutants/mutants.hpp"

#include "validation/mutants/mutant_models.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace clack::validation {

namespace {

using Made = std::unique_ptr<Engine>;

/// Balls that start no nearer to each other than they are wide.
Made make_wider(Scene const& scene) {
    Scene wider = scene;
    wider.system.diameter *= mutants::WiderBalls<double>::widening;
    return mutants::make<PeriodicCube, mutants::WiderBalls>(scene.system, make_start(wider));
}

/// Balls in layers of a grid that move within their layer: its collisions know no third dimension.
Made make_layers(Scene const& given) {
    Scene scene = given;
    scene.arrangement = Arrangement::grid;
    Start start = make_start(scene);
    double const energy = start.velocities.squaredNorm();
    start.velocities.row(2).setZero();
    start.velocities *= std::sqrt(energy / start.velocities.squaredNorm());
    return make_engine(scene.system, scene.method, scene.precision, start);
}

/// What equilibrium forgives.
Made make_unequal(Scene const& scene) {
    Start start = make_start(scene);
    double const energy = start.velocities.squaredNorm();
    for (Eigen::Index k = 0; k < start.velocities.cols(); ++k)
        start.velocities.col(k) *= k % 2 == 0 ? 1.05 : 0.95;
    start.velocities *= std::sqrt(energy / start.velocities.squaredNorm());
    return make_engine(scene.system, scene.method, scene.precision, start);
}

template <template <class> class Container, template <class> class Model,
          template <class, class> class Search = CellGrid>
Made of(Scene const& scene) {
    return mutants::make<Container, Model, Search>(scene.system, make_start(scene));
}

struct Mutant {
    Fault fault;
    char const* name;
    Boundary boundary;
    Made (*make)(Scene const&);
};

Mutant const& mutant_of(Fault const fault) {
    constexpr auto walls = Boundary::walls, periodic = Boundary::periodic;
    static std::array const all{
        Mutant{Fault::wider_balls, "diameter 0.1 % too large", periodic, make_wider},
        Mutant{Fault::stronger_impulses, "impulses 1e-4 too large", periodic,
               of<PeriodicCube, mutants::StrongerImpulses>},
        Mutant{Fault::weaker_impulses, "impulses 1e-4 too small", walls,
               of<WalledCube, mutants::WeakerImpulses>},
        Mutant{Fault::missed_collisions, "one collision in 10000 missed", periodic,
               of<PeriodicCube, mutants::MissedCollisions>},
        Mutant{Fault::late_collisions, "one collision in 100000 late by 1e-6", periodic,
               of<PeriodicCube, mutants::LateCollisions>},
        Mutant{Fault::earlier_normal, "normal of 0.01 before contact", periodic,
               of<PeriodicCube, mutants::EarlierNormal>},
        Mutant{Fault::rounded_velocities, "velocities of 32 bits", periodic,
               of<PeriodicCube, mutants::RoundedVelocities>},
        Mutant{Fault::moved_walls, "walls off by 0.1 %", walls,
               of<WalledCube, mutants::MovedWalls>},
        Mutant{Fault::lossy_walls, "walls of restitution 0.9999", walls,
               of<WalledCube, mutants::LossyWalls>},
        Mutant{Fault::lost_refresh, "refresh of the cells lost", periodic,
               of<PeriodicCube, mutants::LostRefresh>},
        Mutant{Fault::stale_images, "nearest image of the start only", periodic,
               of<PeriodicCube, mutants::LostRefresh, EveryPair>},
        Mutant{Fault::layered_start, "start that never leaves two dimensions", walls, make_layers},
        Mutant{Fault::unequal_speeds, "equal speeds apart by 10 % at the start", walls,
               make_unequal}};
    return *std::find_if(all.begin(), all.end(),
                         [&](Mutant const& mutant) { return mutant.fault == fault; });
}

} // namespace

EngineMaker with(Fault const fault) {
    return [&mutant = mutant_of(fault)](Scene const& scene) {
        if (scene.system.boundary != mutant.boundary)
            throw std::invalid_argument(std::string("no such mutant here: ") + mutant.name);
        return mutant.make(scene);
    };
}

char const* name_of(Fault const fault) { return mutant_of(fault).name; }

} // namespace clack::validation
