// Would the experiment see an engine that is wrong, and is its oracle one?

#include "tests/validation/mutants.hpp"
#include "validation/stepped_runs.hpp"

#include <boost/test/unit_test.hpp>

using namespace clack;
using namespace clack::validation;
using namespace clack::validation::work_precision;

namespace {

constexpr StatePoint point{0.2, 27, 1};

} // namespace

BOOST_AUTO_TEST_CASE(the_engine_lasts_as_long_as_its_rounding_allows_and_a_mutant_does_not) {
    auto const place = scenery(point, 2015);
    double const until = followed(point, Precision::double_);
    ErrorGrowth growth = growth_of(place, 2015);
    Run const oracle = run(place, Method::fast, Precision::quadruple, place.start, until, &growth);
    Point const engine = point_of(point, place, Precision::double_, oracle, growth, 2015);
    BOOST_TEST(engine.horizon > 0.85 * engine.limit); // one run: 8 % of luck
    BOOST_TEST(engine.horizon > 0.85 * engine.tangent_limit);
    BOOST_TEST(engine.horizon < 1.15 * engine.tangent_limit);
    BOOST_TEST(engine.largest < 1e-12);

    auto const wrong =
        mutants::make<WalledCube, mutants::WeakerImpulses>(place.system, place.start);
    Point const mutant = compare(run(*wrong, place, until), oracle);
    BOOST_TEST(mutant.horizon < 0.5 * engine.limit);
    BOOST_TEST(mutant.horizon < 0.5 * engine.tangent_limit);
    BOOST_TEST(mutant.median > 1e-6);
}

BOOST_AUTO_TEST_CASE(quad_follows_finer_decimal_numbers) {
    auto const place = scenery(point, 2015);
    double const until = 8;
    Run const decimal = decimal_run(place, until, 0, 2015);
    Point const quad_point =
        compare(run(place, Method::fast, Precision::quadruple, place.start, until), decimal);
    BOOST_TEST(quad_point.largest < 1e-29);
    BOOST_TEST(quad_point.horizon == matched(decimal.partners, decimal.partners));
    Point const nudged = compare(decimal_run(place, until, 1e-3, 2015), decimal);
    BOOST_TEST(nudged.largest > 1e-3);
}

BOOST_AUTO_TEST_CASE(smaller_steps_of_frames_come_nearer) {
    auto const place = scenery({0.05, 27, 1}, 2015);
    Run const oracle =
        run(place, Method::fast, Precision::quadruple, place.start, spans * final_time);
    Point const coarse = frames_point(place, 0.1, oracle), fine = frames_point(place, 1e-3, oracle);
    BOOST_TEST(fine.median < coarse.median / 10);
    BOOST_TEST(fine.horizon >= coarse.horizon);
    BOOST_TEST(fine.cost > 10 * coarse.cost);
}
