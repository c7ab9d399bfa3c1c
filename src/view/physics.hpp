#pragma once
// What theory says of the balls in view, beside what they do.

#include "observables/pressure.hpp"
#include "view/frame.hpp"

#include <optional>
#include <string>
#include <vector>

namespace clack::view {

/// Pearson's test of one instant's speeds against their exact law, in classes of equal probability.
struct SpeedTest {
    double chi_square = 0;
    int degrees_of_freedom = 0;
    double p_value = 1; // of a larger chi-square, by chance
};

/// Densities of speed, in classes of equal width from 0 to `top`.
struct SpeedHistogram {
    double top = 1;              // [length / time]
    std::vector<float> measured; // of the balls  [time / length]
    std::size_t beyond = 0;      // balls that are faster than top
    std::vector<float> exact,
        maxwell; // at points evenly from 0 to top; none where they do not hold
};

/// Z as it stood at an earlier time: from the samples until then.
struct PressurePoint {
    double time = 0;
    CompressibilityFactor factor;
};

struct Physics {
    double temperature = 0;  // kT
    int directions = 3;      // in which balls move; of fewer, kT and Z are not told
    std::string without_law; // why the speeds come to no law; empty where they do
    SpeedHistogram speeds;
    std::optional<SpeedTest> speed_test; // none for few balls
    CompressibilityFactor compressibility_factor;
    std::optional<Estimate> theory;    // of both; none where the balls are few or no fluid
    std::vector<PressurePoint> course; // of both until now, some dozens of points
    double energy_drift = 0;           // relative, since the first sample
};

struct Range {
    double low, high;
};

/// What a chart of Z shows: theory and all of the course but its first, wild quarter, with errors.
Range range_of(Physics const& physics);

/// From an instant and the samples until then, the first of which is the run's start.
Physics physics_of(Frame const& frame, std::vector<Sample> const& samples);

} // namespace clack::view
