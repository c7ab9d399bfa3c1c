#include "tests/io/made_up_run.hpp"
#include "tests/io/python.hpp"

#include <boost/test/unit_test.hpp>

using namespace clack;
using namespace clack::test;

namespace {

Folder const folder;

int read_with_others(std::string const& path, int count, int frames, std::string const& boundary) {
    auto const command =
        python() + " -W ignore " CLACK_SOURCE_DIR "/tests/io/read_with_others.py " + path + " " +
        std::to_string(count) + " " + std::to_string(frames) + " " + boundary;
    return std::system(command.c_str());
}

} // namespace

BOOST_AUTO_TEST_CASE(h5py_and_mdanalysis_read_what_was_written) {
    BOOST_REQUIRE_MESSAGE(!python().empty(), "no python3 here imports h5py and MDAnalysis: install "
                                             "python3-h5py and python3-mdanalysis");
    auto const path = folder.file("finished.h5");
    for (int const count : {1, 6}) {
        write_made_up_run(path, made_up_header(Boundary::periodic, count), 9);
        BOOST_TEST(read_with_others(path, count, 9, "periodic") == 0);
        write_made_up_run(path, made_up_header(Boundary::walls, count), 9);
        BOOST_TEST(read_with_others(path, count, 9, "none") == 0);
    }
    BOOST_TEST(read_with_others(path, 6, 10, "none") != 0); // the script can say no
}

BOOST_AUTO_TEST_CASE(h5py_follows_a_run_that_is_still_written) {
    auto const path = folder.file("growing.h5");
    TrajectoryWriter writer(path, made_up_header(Boundary::periodic, 6));
    auto start = made_up_point(6, 1, 0);
    writer.flush(start);
    add_made_up(writer, 6, 1, 0, 4);
    auto const command = python() + " -c \"import h5py; f = h5py.File('" + path +
                         "', 'r', libver='latest', swmr=True); "
                         "assert f['particles/balls/position/value'].shape == (4, 6, 3)\"";
    BOOST_TEST(std::system(command.c_str()) == 0);
}
