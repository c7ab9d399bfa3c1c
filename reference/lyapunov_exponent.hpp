#pragma once
// How fast a small error grows in a run of hard balls.

#include "state/system.hpp"

#include <algorithm>
#include <cmath>

namespace clack::reference {

/// Largest Lyapunov exponent over the collision rate of a ball: natural logarithms that an error
/// gains while each ball has one collision with another ball.
/// Fitted to what the experiment `lyapunov` measures at packing fractions 0.001 to 0.45 and 27
/// (periodic: 100) to 1000 balls, and judged by it at others in between: 6 %. The limit of many
/// balls is extrapolated. Denser systems are given the value at the end, which is too large for
/// them; more dilute ones the growth of theory's leading order, -4.311 ln(density), which is too
/// steep (R. van Zon, H. van Beijeren, Ch. Dellago, Phys. Rev. Lett. 80, 2035 (1998)): an error is
/// rather said to grow too fast than too slowly.
inline double lyapunov_exponent_per_collision(System const& system) {
    double const packing_fraction = system.packing_fraction();
    double const eta = std::clamp(packing_fraction, 0.001, 0.45);
    double const logarithm = std::log(eta);
    double const small =
        1 / std::cbrt(static_cast<double>(std::max<std::int64_t>(system.count, 2)));
    double const endless =
        -1.1579 - logarithm * (0.9031 + 0.0482 * logarithm) - eta * (0.1325 + 1.8648 * eta);
    double const finite = -0.2692 + 0.1060 * logarithm;
    double const walls = -0.4843 - 0.0647 * logarithm;
    double const more_dilute = std::log(eta / std::min(packing_fraction, eta));
    return std::exp(endless + small * (finite + (system.boundary == Boundary::walls ? walls : 0))) +
           4.311 * more_dilute;
}

} // namespace clack::reference
