// How long positions can be believed, against runs in quad; and the growth of errors behind it, by
// tangent space against twin runs.

#include "reference/horizon.hpp"
#include "validation/lyapunov.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

using namespace clack;
using namespace clack::validation;

namespace {

lyapunov::StatePoint point(Boundary const boundary, double const packing_fraction) {
    return {boundary, packing_fraction, 100, 0, 1};
}

/// Median error of the positions of a run so many collisions per ball after its start.
double error_after(double const collisions, lyapunov::Fluid const& fluid,
                   Precision const precision) {
    System const system = fluid.engine->system();
    Snapshot const shot = fluid.engine->snapshot();
    double const time = collisions / fluid.rate;
    auto const places = [&](Precision const which) {
        auto const engine =
            make_engine(system, Method::automatic, which, Start{shot.positions, shot.velocities});
        engine->advance({.time = time});
        return exact_places(engine->checkpoint(), system, time);
    };
    auto errors = distances(places(precision), places(Precision::quadruple));
    std::nth_element(errors.begin(), errors.begin() + 50, errors.end());
    return errors[50];
}

/// Tells an observer of impulses that are a little too large.
class Exaggeration final : public CollisionObserver {
public:
    explicit Exaggeration(CollisionObserver& observer) : observer_(observer) {}
    void operator()(Collision<double> const& collision) override {
        Collision<double> more = collision;
        more.impulse *= 1.01;
        observer_(more);
    }

private:
    CollisionObserver& observer_;
};

} // namespace

BOOST_AUTO_TEST_CASE(positions_hold_up_to_the_horizon_and_not_for_long_beyond) {
    for (Boundary const boundary : {Boundary::walls, Boundary::periodic}) {
        for (double const packing_fraction : {0.05, 0.2, 0.4}) {
            auto const fluid = lyapunov::fluid(point(boundary, packing_fraction), 2015);
            System const system = fluid.engine->system();
            for (Precision const precision : {Precision::single_, Precision::double_}) {
                auto const horizon = reference::horizon(system, precision, fluid.rate);
                BOOST_REQUIRE(horizon.has_value());
                double const until = horizon->collisions_per_ball;
                BOOST_TEST(std::abs(horizon->time * fluid.rate - until) < 1e-12 * until);
                BOOST_TEST(error_after(until, fluid, precision) < horizon->error);
                // A horizon that errors grown a millionfold still do not reach says too little.
                double const beyond =
                    until + std::log(1e6) / reference::lyapunov_exponent_per_collision(system);
                BOOST_TEST(error_after(beyond, fluid, precision) > horizon->error);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(collision_rates_are_told_to_a_tenth_but_between_near_walls) {
    for (Boundary const boundary : {Boundary::walls, Boundary::periodic}) {
        for (double const packing_fraction : {0.01, 0.05, 0.2, 0.4}) {
            auto const fluid = lyapunov::fluid(point(boundary, packing_fraction), 2015);
            double const rough = reference::rough_collision_rate(fluid.engine->system(), 1);
            // 1500 collisions: a tenth is four standard errors
            bool const crowded = boundary == Boundary::walls && packing_fraction > 0.3;
            BOOST_TEST(std::abs(rough / fluid.rate - 1) < (crowded ? 0.2 : 0.1));
        }
    }
}

BOOST_AUTO_TEST_CASE(few_balls_and_balls_at_rest_have_no_horizon) {
    System const two{.side = 10, .count = 2}, many{.side = 10, .count = 100};
    BOOST_TEST(!reference::horizon(two, Precision::double_, 1).has_value());
    BOOST_TEST(!reference::horizon(many, Precision::double_, 0).has_value());
    BOOST_TEST(reference::horizon(many, Precision::double_, 1).has_value());
}

BOOST_AUTO_TEST_CASE(a_tangent_vector_grows_as_twins_part) {
    for (Boundary const boundary : {Boundary::walls, Boundary::periodic}) {
        auto const rates = lyapunov::measure_twins(point(boundary, 0.2), 2015);
        BOOST_TEST(std::abs(rates[0] / rates[1] - 1) < 1e-5); // 6e-8 at the worst of many
    }
}

BOOST_AUTO_TEST_CASE(a_tangent_vector_that_hears_of_wrong_impulses_does_not) {
    auto const place = point(Boundary::walls, 0.2);
    auto const growth = [&](bool const exaggerate) {
        auto const fluid = lyapunov::fluid(place, 2015);
        TangentVector vector(fluid.engine->system(), lyapunov::random_differences(100, 1),
                             lyapunov::random_differences(100, 2));
        Exaggeration exaggeration(vector);
        CollisionObserver& observer = vector;
        fluid.engine->advance({.ball_collisions = 1000}, exaggerate ? &exaggeration : &observer);
        vector.move_to(fluid.engine->time());
        return vector.normalise();
    };
    BOOST_TEST(std::abs(growth(true) / growth(false) - 1) > 1e-3);
}
