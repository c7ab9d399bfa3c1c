#pragma once
// The same scenes by every search and queue: one hash a scene, or something is wrong.

#include "neighbours/cell_grid.hpp"
#include "neighbours/every_pair.hpp"
#include "neighbours/neighbour_list.hpp"
#include "scheduling/binary_heap.hpp"
#include "scheduling/calendar.hpp"
#include "scheduling/collision_table.hpp"
#include "simulation/engine_of.hpp"
#include "simulation/epoch.hpp"
#include "validation/lattice_start.hpp"

#include <fmt/format.h>

#include <iterator>
#include <numbers>
#include <string>
#include <vector>

namespace clack::validation {

/// A scene of so many balls, run for so many ball-ball collisions.
struct Way {
    Boundary boundary;
    std::int64_t count;
    double packing_fraction;
    std::uint64_t collisions;

    System system() const {
        System made;
        made.boundary = boundary;
        made.count = count;
        made.side =
            std::cbrt(static_cast<double>(count) * std::numbers::pi / (6 * packing_fraction));
        // 20 bits of a side that no two mathematics libraries differ in
        made.side = std::round(made.side * 0x1p16) * 0x1p-16;
        return made;
    }
    std::string name() const {
        return fmt::format("{} {} {}", boundary == Boundary::walls ? "walls" : "periodic", count,
                           packing_fraction);
    }
};

/// Hundreds of collisions a ball: many times past where rounding would tell two ways apart.
inline std::vector<Way> const ways{{Boundary::walls, 108, 0.01, 10'000},
                                   {Boundary::walls, 256, 0.35, 30'000},
                                   {Boundary::periodic, 108, 0.01, 10'000},
                                   {Boundary::periodic, 256, 0.2, 30'000},
                                   {Boundary::periodic, 500, 0.55, 50'000}};

struct WayHash {
    std::string scene, search, queue;
    std::uint64_t hash;
};

template <template <class> class Container, template <class, class> class Search,
          template <class> class Queue>
WayHash go(Way const& way, std::string search, std::string queue) {
    System const system = way.system();
    EngineOf<Simulation<double, Container, Search, Queue>> engine(
        BallState<double, Container<double>>(system, lattice_start(system, 2015),
                                             epoch_length(system, 1.75)),
        ModelDescription{});
    engine.hash_collisions();
    engine.advance({.ball_collisions = way.collisions}, nullptr);
    return {way.name(), std::move(search), std::move(queue), engine.hash()};
}

/// The three methods of the project.
template <template <class> class Container>
void go_by_methods(Way const& way, std::vector<WayHash>& hashes) {
    hashes.push_back(go<Container, EveryPair, CollisionTable>(way, "EveryPair", "CollisionTable"));
    hashes.push_back(go<Container, CellGrid, BinaryHeap>(way, "CellGrid", "BinaryHeap"));
    hashes.push_back(go<Container, NeighbourList, Calendar>(way, "NeighbourList", "Calendar"));
}

/// What is left of all searches with all queues.
template <template <class> class Container>
void go_by_the_rest(Way const& way, std::vector<WayHash>& hashes) {
    hashes.push_back(go<Container, EveryPair, BinaryHeap>(way, "EveryPair", "BinaryHeap"));
    hashes.push_back(go<Container, EveryPair, Calendar>(way, "EveryPair", "Calendar"));
    hashes.push_back(go<Container, CellGrid, CollisionTable>(way, "CellGrid", "CollisionTable"));
    hashes.push_back(go<Container, CellGrid, Calendar>(way, "CellGrid", "Calendar"));
    hashes.push_back(
        go<Container, NeighbourList, CollisionTable>(way, "NeighbourList", "CollisionTable"));
    hashes.push_back(go<Container, NeighbourList, BinaryHeap>(way, "NeighbourList", "BinaryHeap"));
}

inline std::vector<WayHash> go_all_ways_by_methods() {
    std::vector<WayHash> hashes;
    for (Way const& way : ways) {
        if (way.boundary == Boundary::walls)
            go_by_methods<WalledCube>(way, hashes);
        else
            go_by_methods<PeriodicCube>(way, hashes);
    }
    return hashes;
}

} // namespace clack::validation
