#include "state/errors.hpp"
#include "validation/conservation.hpp"
#include "validation/mutants/mutants.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace clack;
using namespace clack::validation;
using namespace clack::validation::conservation;

namespace {

bool keeps_to_rounding(EngineMaker const& make, Boundary boundary) {
    for (StatePoint const& point : state_points(Profile::quick)) {
        if (point.boundary != boundary) continue;
        System const system = point.scene(0).system;
        auto const moments = measure(point, 1, make);
        if (!std::all_of(moments.begin(), moments.end(),
                         [&](Moment const& moment) { return holds(moment, system); }))
            return false;
    }
    return true;
}

} // namespace

BOOST_AUTO_TEST_CASE(true_engine_keeps_energy_momentum_and_distance) {
    BOOST_TEST(keeps_to_rounding(make_true_engine, Boundary::walls));
    BOOST_TEST(keeps_to_rounding(make_true_engine, Boundary::periodic));
}

BOOST_AUTO_TEST_CASE(impulse_wrong_by_a_ten_thousandth_is_caught) {
    BOOST_TEST(!keeps_to_rounding(with(Fault::stronger_impulses), Boundary::periodic));
}

BOOST_AUTO_TEST_CASE(walls_off_by_a_thousandth_are_caught) {
    BOOST_TEST(!keeps_to_rounding(with(Fault::moved_walls), Boundary::walls));
}

// A missed pair flies on through one another, and is met by the law that stops such a run.
BOOST_AUTO_TEST_CASE(one_collision_missed_in_ten_thousand_is_caught) {
    BOOST_CHECK_THROW(keeps_to_rounding(with(Fault::missed_collisions), Boundary::periodic),
                      LawBroken);
}
