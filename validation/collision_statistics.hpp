#pragma once
// What collisions are like: state points, one measurement, and what it should give.

#include "observables/encounter.hpp"
#include "observables/free_flights.hpp"
#include "observables/pressure.hpp"
#include "reference/finite_size.hpp"
#include "reference/free_flights.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/mutants/engine_maker.hpp"
#include "validation/statistics/goodness_of_fit.hpp"
#include "validation/statistics/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace clack::validation::collision_statistics {

struct StatePoint {
    Boundary boundary;
    std::int64_t count;
    double packing_fraction;
    double production; // collisions per ball that are counted, in one replicate
    int replicates = 16;

    bool is_dilute() const { return packing_fraction < 0.006; }
    std::string text() const {
        return fmt::format("{} count={} packing_fraction={} production={}",
                           boundary == Boundary::walls ? "walls" : "periodic", count,
                           packing_fraction, production);
    }
    Scene scene(std::uint64_t const seed) const {
        Scene scene;
        scene.system.boundary = boundary;
        scene.system.count = count;
        scene.system.side =
            std::cbrt(static_cast<double>(count) * std::numbers::pi / 6 / packing_fraction);
        scene.arrangement = Arrangement::random;
        scene.seed = seed;
        return scene;
    }
};

/// Few balls, whose laws are visibly not those of infinitely many; a gas so dilute, and of so many
/// balls, that its free flights are those of the limit; a fluid and a dense one.
inline std::vector<StatePoint> state_points(Profile const profile) {
    double const longer = profile == Profile::quick ? 1 : 20;
    return {{Boundary::walls, 8, 0.1, 20'000 * longer},
            {Boundary::periodic, 2048, 0.002, 150 * longer},
            {Boundary::periodic, 500, 0.3, 600 * longer},
            {Boundary::periodic, 864, 0.45, 400 * longer}};
}

/// What one replicate measures, then histograms of the free time and of the squared impact
/// parameter.
enum Value : std::size_t {
    rate_ratio,           // collisional part of Z by the rate over the same by the virial
    normal_speed_squared, // <v_n^2> m / kT
    impact_squared,       // <b^2> / diameter^2
    impact_fourth,
    cubic_anisotropy, // <n_x^4 + n_y^4 + n_z^4> of the line of centres
    path_over_speed,  // mean free path / (mean speed x mean free time)
    time_squared,     // <t^2> / <t>^2, and so on
    time_cubed,
    length_squared,
    length_cubed,
    no_collision_in_three, // probability of none in three mean free times
    normal_speed_fit,      // p-value of Kolmogorov and Smirnov's test
    impact_fit,
    value_count
};
constexpr std::size_t time_bins = 32, impact_bins = 20;
constexpr double time_bin = 0.25; // in mean free times

/// Flights and the geometry of collisions.
class Watcher : public CollisionObserver {
public:
    ///   spacing   of the encounters that enter the tests of fit, in collisions: so far apart that
    ///             they are independent
    Watcher(std::int64_t const count, std::uint64_t const spacing)
        : flights(count), spacing_(spacing) {}

    void operator()(Collision<double> const& collision) override {
        flights(collision);
        if (collision.kind != CollisionKind::ball) return;
        Encounter const met = encounter_of(collision);
        double const b2 = met.impact_parameter_squared;
        ++encounters;
        speed2 += met.normal_speed * met.normal_speed;
        impact2 += b2;
        impact4 += b2 * b2;
        line4 += met.line_of_centres.array().pow(4).sum();
        ++impacts[std::min(impact_bins - 1, static_cast<std::size_t>(b2 * impact_bins))];
        if (encounters % spacing_ == 0) sparse.push_back({met.normal_speed, b2});
    }

    FreeFlights flights;
    std::uint64_t encounters = 0;
    double speed2 = 0, impact2 = 0, impact4 = 0, line4 = 0;
    std::array<double, impact_bins> impacts{};
    std::vector<std::pair<double, double>> sparse; // normal speed, squared impact parameter

private:
    std::uint64_t spacing_;
};

/// Probability that the normal relative speed of a colliding pair is up to this one, at constant
/// energy: m v_n^2 / (4E) is Beta(1, (n-1)/2) for n degrees of freedom. Exact at every density,
/// since a collision weighs the uniform law on the energy sphere with v_n.
inline double normal_speed_probability(double const speed2_over_top, double const freedom) {
    return 1 - std::pow(1 - speed2_over_top, (freedom - 1) / 2);
}

/// Mean of |v| over the root of kT/m at constant energy. [for all balls, s = N/(N-1) if periodic]
inline double mean_speed(System const& system) {
    double const n = system.degrees_of_freedom();
    double const share = 3 * static_cast<double>(system.count) / n; // s
    double const logs = std::lgamma(2) - std::lgamma(1.5) + std::lgamma(n / 2) -
                        std::lgamma((n + 1) / 2); // <sqrt q>, q being Beta(3/2, (n-3)/2)
    return std::sqrt(n / share) * std::exp(logs);
}

inline void add_flights(Measurement& values, std::vector<FreeFlight> const& flights,
                        double const mean_speed_of_run) {
    auto const count = static_cast<double>(flights.size());
    double t1 = 0, l1 = 0;
    for (FreeFlight const& flight : flights) {
        t1 += flight.time / count;
        l1 += flight.length / count;
    }
    double t2 = 0, t3 = 0, l2 = 0, l3 = 0, none = 0;
    std::array<double, time_bins> histogram{};
    for (FreeFlight const& flight : flights) {
        double const t = flight.time / t1, l = flight.length / l1;
        t2 += t * t / count;
        t3 += t * t * t / count;
        l2 += l * l / count;
        l3 += l * l * l / count;
        none += std::max(0.0, t - 3) / count; // a flight leaves so much room for the window
        auto const bin = static_cast<std::size_t>(t / time_bin);
        if (bin < time_bins) histogram[bin] += 1 / (count * time_bin);
    }
    values[path_over_speed] = l1 / (t1 * mean_speed_of_run);
    values[time_squared] = t2;
    values[time_cubed] = t3;
    values[length_squared] = l2;
    values[length_cubed] = l3;
    values[no_collision_in_three] = none;
    values.insert(values.end(), histogram.begin(), histogram.end());
}

inline void add_fits(Measurement& values, Watcher const& watcher, double const top_speed2,
                     double const freedom) {
    std::vector<double> speeds, impacts;
    for (auto const& [speed, impact] : watcher.sparse) {
        speeds.push_back(normal_speed_probability(speed * speed / top_speed2, freedom));
        impacts.push_back(impact);
    }
    values[normal_speed_fit] = kolmogorov_smirnov(speeds).p_value;
    values[impact_fit] = kolmogorov_smirnov(impacts).p_value;
}

/// The span that counts is a time that is fixed before it begins.
inline Measurement measure(StatePoint const& point, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    constexpr double equilibration = 50; // collisions per ball
    auto const engine = make(point.scene(seed));
    System const& system = engine->system();
    auto const count = static_cast<double>(point.count);
    Watcher early(point.count, 1);
    engine->advance({.ball_collisions = static_cast<std::uint64_t>(equilibration * count / 2)},
                    &early);
    double const until = engine->time() * (1 + point.production / equilibration);
    Watcher watcher(point.count, static_cast<std::uint64_t>(5 * count));
    watcher.flights = early.flights;
    watcher.flights.forget();
    Tallies const before = engine->tallies();
    double const begin = engine->time();
    engine->advance({.time = until}, &watcher);

    double const freedom = system.degrees_of_freedom();
    double const energy = engine->kinetic_energy();
    double const kt = temperature(system, energy, engine->momentum());
    double const span = until - begin, thermal = std::sqrt(kt / system.mass);
    auto const met = static_cast<double>(watcher.encounters);
    double const rate = 2 * met / count / span * system.diameter / thermal;
    double const virial = engine->tallies().virial - before.virial;
    Measurement values(value_count);
    values[rate_ratio] =
        reference::collisional_from_rate(rate, freedom) / (virial / (3 * count * kt * span));
    values[normal_speed_squared] = watcher.speed2 / met / (thermal * thermal);
    values[impact_squared] = watcher.impact2 / met;
    values[impact_fourth] = watcher.impact4 / met;
    values[cubic_anisotropy] = watcher.line4 / met;
    add_flights(values, watcher.flights.flights(), mean_speed(system) * thermal);
    add_fits(values, watcher, 4 * energy / system.mass, freedom);
    for (double const impact : watcher.impacts) values.push_back(impact * impact_bins / met);
    return values;
}

/// Enters quantities of one point.
struct Entering {
    Ledger& ledger;
    StatePoint const& point;
    std::vector<Measurement> const& replicates;

    std::vector<std::string> state() const {
        return {point.boundary == Boundary::walls ? "walls" : "periodic", cell(point.count),
                fmt::format("{}", point.packing_fraction)};
    }
    std::vector<double> all(Value const value) const {
        std::vector<double> values;
        for (Measurement const& measurement : replicates) values.push_back(measurement[value]);
        return values;
    }
    void compare(Value const value, Quantity const& quantity, double const reference,
                 double const margin) const {
        ledger.compare(state(), quantity, {{}, mean_of(all(value)), reference, 0, margin});
    }
    /// With half the distance from an exponential law as the margin, so that one that agrees cannot
    /// be that.
    void not_exponential(Value const value, Quantity const& quantity, double const reference,
                         double const exponential) const {
        compare(value, quantity, reference, std::abs(reference - exponential) / 2);
    }
    void fit(Value const value, Quantity const& quantity) const {
        ledger.fit(state(), quantity, fisher(all(value)));
    }
};

inline void enter_encounters(Entering const& point, double const freedom) {
    constexpr double part = 2.5e-3; // half of what one grazing collision in a hundred does to <b^2>
    point.compare(rate_ratio, {"rate_ratio", "$Z_{\\text{c,rate}}/Z_{\\text{c,virial}}$"}, 1, part);
    point.compare(normal_speed_squared, {"normal_speed_squared", "$m\\langle v_n^2\\rangle/\\kT$"},
                  4 * freedom / (freedom + 1), 4 * part);
    point.compare(impact_squared, {"impact_squared", "$\\langle b^2\\rangle/\\sigma^2$"}, 0.5,
                  0.5 * part);
    point.compare(impact_fourth, {"impact_fourth", "$\\langle b^4\\rangle/\\sigma^4$"}, 1.0 / 3,
                  part);
    point.compare(path_over_speed, {"path_over_speed", "$\\ell\\nu/\\langle v\\rangle$"}, 1, part);
    if (point.point.boundary == Boundary::periodic)
        point.compare(cubic_anisotropy, {"cubic_anisotropy", "$\\langle\\sum_x n_x^4\\rangle$"},
                      0.6, 0.6 * part);
    point.fit(normal_speed_fit, {"normal_speed_fit", "$v_n$"});
    point.fit(impact_fit, {"impact_fit", "$b^2$"});
}

inline void enter_flights(Entering const& point) {
    namespace dilute = reference::free_flights;
    double const* const exponential = dilute::exponential;
    point.not_exponential(time_squared,
                          {"time_squared", "$\\langle t^2\\rangle/\\langle t\\rangle^2$"},
                          dilute::time_moment(2), exponential[2]);
    point.not_exponential(time_cubed, {"time_cubed", "$\\langle t^3\\rangle/\\langle t\\rangle^3$"},
                          dilute::time_moment(3), exponential[3]);
    point.not_exponential(length_squared,
                          {"length_squared", "$\\langle l^2\\rangle/\\langle l\\rangle^2$"},
                          dilute::length_moment(2), exponential[2]);
    point.not_exponential(length_cubed,
                          {"length_cubed", "$\\langle l^3\\rangle/\\langle l\\rangle^3$"},
                          dilute::length_moment(3), exponential[3]);
    point.not_exponential(no_collision_in_three,
                          {"no_collision_in_three", "$P_0(3\\langle t\\rangle)$"},
                          dilute::time_survival(3), std::exp(-3.0)); // Poisson's
}

/// Enters what the replicates of a point say.
inline void enter(Ledger& ledger, StatePoint const& point,
                  std::vector<Measurement> const& replicates) {
    Entering const entering{ledger, point, replicates};
    enter_encounters(entering, point.scene(0).system.degrees_of_freedom());
    if (point.is_dilute()) enter_flights(entering);
}

} // namespace clack::validation::collision_statistics
