#include "simulation/model_choice.hpp"

#include "neighbours/cell_grid.hpp"
#include "neighbours/neighbour_list.hpp"
#include "state/container.hpp"

#include <algorithm>
#include <cmath>

namespace clack {

namespace {

// The table of choices, as measured on one machine: the rates of all searches with all queues for 2
// to 32000 balls at packing fractions from 1e-5 to 0.54. Beside its bounds the two sides of each
// are within a tenth, and the experiment `price_of_generality` watches that they stay so.

/// Up to so many balls a queue saves less than it costs.
std::int64_t table_max(System const& system) {
    return system.boundary == Boundary::walls ? 10 : 16;
}

/// Dense enough for lists to cost less than cells, among 500 to 32 000 balls alike.
bool lists_pay(System const& system) {
    using List = NeighbourList<double, PeriodicCube<double>>;
    return system.packing_fraction() >= 0.345 && List::fits(system);
}

/// Up to so many balls it costs less to look at all of them than to keep an index. A ball between
/// walls then never expires, which saves the more the thinner the gas; in a periodic cube it does.
double every_pair_max(System const& system) {
    double const eta = system.packing_fraction();
    if (system.boundary == Boundary::periodic) return std::min(24 + 100 * eta, 50.0);
    return lists_pay(system) ? 20 : std::min(20 + 6.5 / std::sqrt(eta), 180.0);
}

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
    if (lists_pay(system)) {
        return {SearchKind::neighbour_list, QueueKind::calendar,
                "dense: lists of near balls live long"};
    }
    return {SearchKind::cell_grid, QueueKind::calendar, "dilute: cells cost less than lists"};
}

ModelChoice automatic(System const& system) {
    if (static_cast<double>(system.count) <= every_pair_max(system)) {
        return {SearchKind::every_pair, QueueKind::calendar,
                "so few balls that checking all pairs is quickest"};
    }
    return fast(system);
}

} // namespace

ModelChoice choose_model(System const& system, Method method, Precision) {
    if (method == Method::table)
        return {SearchKind::every_pair, QueueKind::collision_table, "the report's method"};
    if (touches_through_several_images(system)) {
        // Each pair takes long to predict, and a heap asks for fewer predictions than the table.
        return {SearchKind::every_pair, QueueKind::binary_heap,
                "the box is below four diameters: all pairs and images are checked"};
    }
    if (method == Method::automatic && system.count <= table_max(system)) {
        return {SearchKind::every_pair, QueueKind::collision_table,
                "so few balls that the report's table is quickest"};
    }
    using Cells = CellGrid<double, PeriodicCube<double>>;
    if (!Cells::fits(system)) {
        return {SearchKind::every_pair,
                method == Method::heap ? QueueKind::binary_heap : QueueKind::calendar,
                "the box is too narrow for cells: all pairs are checked"};
    }
    if (method == Method::heap)
        return {SearchKind::cell_grid, QueueKind::binary_heap, "the textbook method"};
    return method == Method::fast ? fast(system) : automatic(system);
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
