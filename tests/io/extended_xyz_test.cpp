#include "io/extended_xyz.hpp"
#include "tests/io/made_up_run.hpp"

#include <boost/test/unit_test.hpp>

#include <sstream>

using namespace clack;
using namespace clack::test;

BOOST_AUTO_TEST_CASE(every_bit_comes_back_from_the_text) {
    System const system{Boundary::periodic, 20.0 / 3, 4, 0.7, 1};
    auto const frame = made_up_frame(4, 3);
    std::stringstream text;
    write_extended_xyz(text, system, frame);

    std::string line;
    std::getline(text, line);
    BOOST_TEST(line == "4");
    std::getline(text, line);
    BOOST_TEST(line == "Lattice=\"6.666666666666667 0 0 0 6.666666666666667 0 0 0 "
                       "6.666666666666667\" "
                       "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1 "
                       "pbc=\"T T T\" Time=0.30000000000000004 Step=30");
    for (Eigen::Index i = 0; i < 4; ++i) {
        std::string species;
        Eigen::Vector3d place, velocity;
        double radius = 0;
        Eigen::Index id = -1;
        text >> species >> place.x() >> place.y() >> place.z() >> velocity.x() >> velocity.y() >>
            velocity.z() >> radius >> id;
        BOOST_TEST(species == "X");
        BOOST_TEST((place == frame.positions.col(i)));
        BOOST_TEST((velocity == frame.velocities.col(i)));
        BOOST_TEST(radius == 0.35);
        BOOST_TEST(id == i);
    }
    text >> line;
    BOOST_TEST(text.eof());
}

BOOST_AUTO_TEST_CASE(walls_do_not_wrap) {
    std::stringstream text;
    write_extended_xyz(text, {Boundary::walls, 5, 1, 1, 1}, made_up_frame(1, 0));
    BOOST_TEST(text.str().find("pbc=\"F F F\"") != std::string::npos);
}
