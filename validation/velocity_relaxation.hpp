#pragma once
// How balls that start with one speed forget it: the second half of velocity_distribution.

#include "validation/velocity_distribution.hpp"

#include "reference/equation_of_state.hpp"
#include "reference/finite_size.hpp"

namespace clack::validation::velocity_distribution {

/// Many starts, each followed over a few collisions per ball.
struct Relaxation {
    std::int64_t count = 500;
    double packing_fraction = 0.1;
    int replicates = 200;

    std::string text() const {
        return fmt::format("relaxation count={} packing_fraction={}", count, packing_fraction);
    }
};

/// About how many collisions each ball has had at the looks.
inline std::vector<double> relaxation_looks() {
    std::vector<double> looks;
    for (int tenth = 1; tenth <= 10; ++tenth) looks.push_back(tenth / 10.0);
    for (int half = 3; half <= 24; ++half) looks.push_back(half / 2.0);
    return looks;
}

/// Collisions per ball so far and <v^4> / <v^2>^2, look by look, at fixed times.
inline Measurement measure(Relaxation const& relaxation, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    Scene const scene = scene_of(relaxation.count, relaxation.packing_fraction, seed);
    auto const engine = make(scene);
    auto const count = static_cast<double>(relaxation.count);
    double const rate = reference::collision_rate(
        reference::modified_klm(relaxation.packing_fraction) - 1, 3 * count);
    Measurement values;
    for (double const look : relaxation_looks()) {
        engine->advance({.time = look / rate});
        values.push_back(2 * static_cast<double>(engine->tallies().ball_collisions) / count);
        values.push_back(fourth_moment_of(engine->snapshot().velocities));
    }
    return values;
}

/// Rise of <v^4> / <v^2>^2 per collision of a ball, at the start: two balls of one speed v that
/// meet in random directions have V^2 g^2 = v^4 sin^2(theta) with the speed V of their centre and g
/// of one against the other; weighed with g it is (24/35) v^4, and two thirds of it are the rise of
/// v_1^4 + v_2^4 when the direction of g is drawn anew.
constexpr double first_rise = 8.0 / 35;

/// <v^4> / <v^2>^2 against collisions per ball, over many starts.
inline Csv course_of(Relaxation const& relaxation, std::vector<Measurement> const& replicates) {
    Csv csv({"collisions_per_ball", "fourth_moment", "fourth_moment_error", "first_rise",
             "fourth_moment_theory"});
    double const end =
        law_of({relaxation.count, relaxation.packing_fraction, 0, 0, 0, 0}).fourth_moment_ratio();
    csv.row(0, Estimate{1, 0}, 1, end);
    for (std::size_t look = 0; look < relaxation_looks().size(); ++look) {
        double const collisions = mean_of(replicates, 2 * look).value;
        csv.row(collisions, mean_of(replicates, 2 * look + 1), 1 + first_rise * collisions, end);
    }
    return csv;
}

} // namespace clack::validation::velocity_distribution
