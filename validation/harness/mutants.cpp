#include "validation/harness/mutants.hpp"

#include "validation/harness/mutant_models.hpp"

#include <stdexcept>

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
Made make_layers(Scene scene) {
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

Made between_walls(Fault const fault, Scene const& scene) {
    switch (fault) {
    case Fault::weaker_impulses:
        return of<WalledCube, mutants::WeakerImpulses>(scene);
    case Fault::moved_walls:
        return of<WalledCube, mutants::MovedWalls>(scene);
    case Fault::lossy_walls:
        return of<WalledCube, mutants::LossyWalls>(scene);
    case Fault::layered_start:
        return make_layers(scene);
    case Fault::unequal_speeds:
        return make_unequal(scene);
    default:
        throw std::invalid_argument("no such mutant between walls");
    }
}

Made in_periodic_cube(Fault const fault, Scene const& scene) {
    switch (fault) {
    case Fault::wider_balls:
        return make_wider(scene);
    case Fault::stronger_impulses:
        return of<PeriodicCube, mutants::StrongerImpulses>(scene);
    case Fault::missed_collisions:
        return of<PeriodicCube, mutants::MissedCollisions>(scene);
    case Fault::late_collisions:
        return of<PeriodicCube, mutants::LateCollisions>(scene);
    case Fault::earlier_normal:
        return of<PeriodicCube, mutants::EarlierNormal>(scene);
    case Fault::rounded_velocities:
        return of<PeriodicCube, mutants::RoundedVelocities>(scene);
    case Fault::lost_refresh:
        return of<PeriodicCube, mutants::LostRefresh>(scene);
    case Fault::stale_images:
        return of<PeriodicCube, mutants::LostRefresh, EveryPair>(scene);
    default:
        throw std::invalid_argument("no such mutant in a periodic cube");
    }
}

} // namespace

EngineMaker with(Fault const fault) {
    return [fault](Scene const& scene) {
        return scene.system.boundary == Boundary::walls ? between_walls(fault, scene)
                                                        : in_periodic_cube(fault, scene);
    };
}

char const* name_of(Fault const fault) {
    switch (fault) {
    case Fault::wider_balls:
        return "diameter 0.1 % too large";
    case Fault::stronger_impulses:
        return "impulses 1e-4 too large";
    case Fault::weaker_impulses:
        return "impulses 1e-4 too small";
    case Fault::missed_collisions:
        return "one collision in 10000 missed";
    case Fault::late_collisions:
        return "one collision in 100000 late by 1e-6";
    case Fault::earlier_normal:
        return "normal of 0.01 before contact";
    case Fault::rounded_velocities:
        return "velocities of 32 bits";
    case Fault::moved_walls:
        return "walls off by 0.1 %";
    case Fault::lossy_walls:
        return "walls of restitution 0.9999";
    case Fault::lost_refresh:
        return "refresh of the cells lost";
    case Fault::stale_images:
        return "nearest image of the start only";
    case Fault::layered_start:
        return "start that never leaves two dimensions";
    case Fault::unequal_speeds:
        return "equal speeds apart by 10 % at the start";
    }
    return "";
}

} // namespace clack::validation
