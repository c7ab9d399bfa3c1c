#pragma once
// Until when the positions of a run can be believed.

namespace clack {

/// Rounding errors grow exponentially: up to here positions hold to the stated error, beyond it
/// only statistics do.
struct Horizon {
    double error = 0;               // of positions, typical of the balls  [diameters]
    double collisions_per_ball = 0; // of a ball with other balls, since time 0
    double time = 0;                // since time 0
};

} // namespace clack
