// Random arrangements that are grown: what they promise at every density that they reach.

#include "scenes/insertion.hpp"
#include "scenes/packing.hpp"
#include "tests/scenes/places.hpp"
#include "tests/scenes/scene_text.hpp"

using namespace clack;
using namespace clack::test;

namespace {

System system_of(Boundary boundary, std::int64_t count, double packing_fraction) {
    return {boundary, side_of_packing_fraction(count, 1.3, packing_fraction), count, 1.3, 1};
}

} // namespace

BOOST_AUTO_TEST_CASE(periodic_random_places_hold_no_overlap_up_to_their_limit) {
    for (std::int64_t const count : {2, 4, 8, 32, 100, 500})
        for (double const packing_fraction : {0.26, 0.4, 0.49, 0.55, 0.6}) {
            System const system = system_of(Boundary::periodic, count, packing_fraction);
            BOOST_TEST_CONTEXT(count << " balls at " << packing_fraction)
            check_places(system, place_at_random(system, 1));
        }
}

BOOST_AUTO_TEST_CASE(random_places_between_walls_hold_no_overlap_up_to_their_limit) {
    for (std::int64_t const count : {100, 400}) {
        double const limit = largest_packing_fraction(Arrangement::random, Boundary::walls, count);
        for (double const share : {0.4, 0.6, 0.8, 0.98}) {
            System const system = system_of(Boundary::walls, count, share * limit);
            BOOST_TEST_CONTEXT(count << " balls at " << system.packing_fraction())
            check_places(system, place_at_random(system, 1));
        }
    }
}

BOOST_AUTO_TEST_CASE(a_few_balls_between_walls_find_room) {
    for (std::int64_t const count : {2, 3, 4, 5, 8, 14, 20, 32, 50}) {
        System const system = system_of(Boundary::walls, count, 0.25);
        BOOST_TEST_CONTEXT(count << " balls")
        check_places(system, place_at_random(system, 1));
    }
}

BOOST_AUTO_TEST_CASE(balls_that_jam_are_refused) {
    auto const text = changed(changed(correct_scene, "periodic", "walls"), "fcc", "random");
    auto const message = start_message(changed(changed(text, "count = 100", "count = 5"),
                                               "side = 20.0", "packing_fraction = 0.5"));
    std::string const expected = "arrangement = \"random\": the balls jam while they grow";
    BOOST_TEST(beginning(message, expected) == expected, message);
    BOOST_TEST(message.ends_with("(scene.toml)"), message);
}

BOOST_AUTO_TEST_CASE(grown_places_have_these_bits_on_every_machine) {
    BOOST_TEST(hash_of(place_at_random(system_of(Boundary::periodic, 500, 0.55), 2015)) ==
               11685671421605238906u);
    BOOST_TEST(hash_of(place_at_random(system_of(Boundary::walls, 300, 0.45), 2015)) ==
               4536300301664325509u);
}
