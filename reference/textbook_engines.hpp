#pragma once
// The engine with one rule exchanged for what textbooks and first programs do, to see what the
// choice costs. Each is compiled from the engine's own templates.

#include "simulation/engine.hpp"

#include <memory>

namespace clack::reference {

enum class Textbook {
    naive_root,     // t = (-b - sqrt(b^2 - a c)) / a
    zero_is_never,  // a contact at t <= 0 is no contact: what has just collided is left alone
    not_the_same,   // a ball does not collide with the partner it has just collided with
    absolute_time,  // one clock that counts from the run's beginning
    cell_from_floor // a ball is in the cell that its coordinate says
};

/// An engine in double precision that goes on from a checkpoint, its search that of every pair
/// (but for cell_from_floor) and its queue the table.
std::unique_ptr<Engine> make_textbook_engine(Textbook rule, System const& system,
                                             Checkpoint const& checkpoint);

} // namespace clack::reference
