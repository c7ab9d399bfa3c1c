#pragma once
// From a choice of model to the one simulation that was compiled for it. One source file a floating
// type includes this, so that they compile side by side.

#include "neighbours/cell_grid.hpp"
#include "neighbours/every_pair.hpp"
#include "neighbours/neighbour_list.hpp"
#include "scheduling/binary_heap.hpp"
#include "scheduling/calendar.hpp"
#include "scheduling/collision_table.hpp"
#include "simulation/engine_of.hpp"
#include "simulation/epoch.hpp"
#include "simulation/model_choice.hpp"

namespace clack {

/// Either where a run starts or where it goes on.
struct Origin {
    Start const* start = nullptr;
    Checkpoint const* checkpoint = nullptr;
};

template <class Real>
std::unique_ptr<Engine> build_engine(System const& system, Method method, Precision precision,
                                     Origin const& origin);

extern template std::unique_ptr<Engine> build_engine<float>(System const&, Method, Precision,
                                                            Origin const&);
extern template std::unique_ptr<Engine> build_engine<double>(System const&, Method, Precision,
                                                             Origin const&);
extern template std::unique_ptr<Engine> build_engine<long double>(System const&, Method, Precision,
                                                                  Origin const&);
extern template std::unique_ptr<Engine> build_engine<quad>(System const&, Method, Precision,
                                                           Origin const&);

namespace detail {

/// Root mean square speed of a start.
inline double speed_of(Start const& start) {
    double sum = 0;
    for (Eigen::Index i = 0; i < start.velocities.cols(); ++i)
        sum += dot<double>(start.velocities.col(i), start.velocities.col(i));
    return std::sqrt(sum / static_cast<double>(start.velocities.cols()));
}

template <class Real, template <class> class Container, template <class, class> class Search,
          template <class> class Queue>
std::unique_ptr<Engine> assemble(System const& system, Origin const& origin,
                                 ModelDescription const& model) {
    using State = BallState<Real, Container<Real>>;
    using Built = EngineOf<Simulation<Real, Container, Search, Queue>>;
    if (origin.start) {
        return std::make_unique<Built>(
            State(system, *origin.start, epoch_length(system, speed_of(*origin.start))), model);
    }
    auto engine = std::make_unique<Built>(State(system, *origin.checkpoint), model);
    if (origin.checkpoint->hash != 0) engine->resume_hash(origin.checkpoint->hash);
    return engine;
}

template <class Real, template <class> class Container>
std::unique_ptr<Engine> choose(System const& system, Origin const& origin,
                               ModelChoice const& choice, ModelDescription const& model) {
    if (choice.queue == QueueKind::collision_table)
        return assemble<Real, Container, EveryPair, CollisionTable>(system, origin, model);
    if (choice.queue == QueueKind::binary_heap) {
        return choice.search == SearchKind::every_pair
                   ? assemble<Real, Container, EveryPair, BinaryHeap>(system, origin, model)
                   : assemble<Real, Container, CellGrid, BinaryHeap>(system, origin, model);
    }
    switch (choice.search) {
    case SearchKind::every_pair:
        return assemble<Real, Container, EveryPair, Calendar>(system, origin, model);
    case SearchKind::cell_grid:
        return assemble<Real, Container, CellGrid, Calendar>(system, origin, model);
    default:
        return assemble<Real, Container, NeighbourList, Calendar>(system, origin, model);
    }
}

} // namespace detail

template <class Real>
std::unique_ptr<Engine> build_engine(System const& system, Method method, Precision precision,
                                     Origin const& origin) {
    ModelChoice const choice = choose_model(system, method, precision);
    ModelDescription const model = describe(choice, system, precision);
    if (system.boundary == Boundary::walls)
        return detail::choose<Real, WalledCube>(system, origin, choice, model);
    return detail::choose<Real, PeriodicCube>(system, origin, choice, model);
}

} // namespace clack
