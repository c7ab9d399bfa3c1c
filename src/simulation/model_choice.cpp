#include "simulation/model_choice.hpp"

#include "neighbours/neighbour_list.hpp"
#include "state/container.hpp"

namespace clack {

namespace {

constexpr std::int64_t every_pair_max = 40; // measured: from here on cells cost less
constexpr double list_packing_min = 0.38;   // measured: from here on lists cost less than cells

char const* name_of(SearchKind search) {
    switch (search) {
    case SearchKind::every_pair:
        return "EveryPair";
    case SearchKind::cell_grid:
        return "CellGrid";
    default:
        return "NeighbourList";
    }
}

char const* name_of(QueueKind queue) {
    switch (queue) {
    case QueueKind::collision_table:
        return "CollisionTable";
    case QueueKind::binary_heap:
        return "BinaryHeap";
    default:
        return "Calendar";
    }
}

ModelChoice fast(System const& system) {
    using List = NeighbourList<double, PeriodicCube<double>>;
    if (system.packing_fraction() >= list_packing_min && List::fits(system)) {
        return {SearchKind::neighbour_list, QueueKind::calendar,
                "dense: lists of near balls live long"};
    }
    return {SearchKind::cell_grid, QueueKind::calendar, "dilute: cells cost less than lists"};
}

} // namespace

ModelChoice choose_model(System const& system, Method method, Precision) {
    if (method == Method::table)
        return {SearchKind::every_pair, QueueKind::collision_table, "the report's method"};
    if (method == Method::automatic && system.count <= every_pair_max) {
        return {SearchKind::every_pair, QueueKind::collision_table,
                "so few balls that checking all pairs is quickest"};
    }
    ModelChoice choice =
        method == Method::heap
            ? ModelChoice{SearchKind::cell_grid, QueueKind::binary_heap, "the textbook method"}
            : fast(system);
    if (touches_through_several_images(system)) {
        choice.search = SearchKind::every_pair;
        choice.reason = "the box is below four diameters: all pairs and images are checked";
    }
    return choice;
}

ModelDescription describe(ModelChoice const& choice, System const& system, Precision precision) {
    return {system.boundary == Boundary::walls ? "walls" : "periodic", name_of(choice.search),
            name_of(choice.queue), name_of(precision), choice.reason};
}

char const* name_of(Precision precision) {
    switch (precision) {
    case Precision::single_:
        return "float";
    case Precision::double_:
        return "double";
    case Precision::extended:
        return "long double";
    default:
        return "quad";
    }
}

char const* name_of(Method method) {
    switch (method) {
    case Method::automatic:
        return "auto";
    case Method::table:
        return "table";
    case Method::heap:
        return "heap";
    default:
        return "fast";
    }
}

} // namespace clack
