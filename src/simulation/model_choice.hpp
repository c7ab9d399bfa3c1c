#pragma once
// Which search and which queue run a scene: model no more than it needs.

#include "simulation/engine.hpp"

namespace clack {

enum class SearchKind { every_pair, cell_grid, neighbour_list };
enum class QueueKind { collision_table, binary_heap, calendar };

/// What `make_engine` will build, and why.
struct ModelChoice {
    SearchKind search;
    QueueKind queue;
    char const* reason; // a literal
};

/// The search and queue for a method; `automatic` goes by number of balls and packing fraction.
ModelChoice choose_model(System const& system, Method method, Precision precision);

/// The same in words.
ModelDescription describe(ModelChoice const& choice, System const& system, Precision precision);

/// "float", "double", "long double" or "quad", as scene files have it.
char const* name_of(Precision precision);
/// "auto", "table", "heap" or "fast".
char const* name_of(Method method);

} // namespace clack
