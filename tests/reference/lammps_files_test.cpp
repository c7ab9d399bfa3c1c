#include "reference/lammps_files.hpp"

#include "state/errors.hpp"
#include "tests/validation/harness/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace clack;
using namespace clack::reference;

namespace {

constexpr char const* two_frames = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\n"
                                   "ITEM: BOX BOUNDS ff ff ff\n0 4\n0 4\n0 4\n"
                                   "ITEM: ATOMS id x y z vx vy vz\n"
                                   "1 0.10000000000000001 2 3 -1 0 1e-300\n"
                                   "2 1 1.5 1.25 0 0 0\n"
                                   "ITEM: TIMESTEP\n50\nITEM: NUMBER OF ATOMS\n2\n"
                                   "ITEM: BOX BOUNDS ff ff ff\n0 4\n0 4\n0 4\n"
                                   "ITEM: ATOMS id x y z vx vy vz\n"
                                   "1 0.30000000000000004 2 3 -1 0 0\n2 1 1 1 0 0 0\n";

struct DumpFile {
    TemporaryDirectory directory{"lammps_files_test"};
    std::filesystem::path path = directory.path / "run.dump";

    explicit DumpFile(std::string const& text) { std::ofstream(path) << text; }
};

void refuse(std::string const& text, std::string const& words) {
    DumpFile const file(text);
    BOOST_CHECK_EXCEPTION(read_lammps_dump(file.path), InputError, [&](InputError const& error) {
        BOOST_TEST_MESSAGE(error.what());
        return std::string(error.what()).find(words) != std::string::npos;
    });
}

std::string with(std::string text, std::string const& what, std::string const& instead) {
    return text.replace(text.find(what), what.size(), instead);
}

DumpFrame contacts(std::int64_t step, std::vector<std::pair<int, int>> const& pairs) {
    DumpFrame frame{step, {"c_who[1]", "c_who[2]"}, {}};
    frame.rows.resize(static_cast<Eigen::Index>(pairs.size()), 2);
    for (std::size_t k = 0; k < pairs.size(); ++k)
        frame.rows.row(static_cast<Eigen::Index>(k)) << pairs[k].first, pairs[k].second;
    return frame;
}

} // namespace

BOOST_AUTO_TEST_CASE(frames_keep_every_digit) {
    DumpFile const file(two_frames);
    auto const frames = read_lammps_dump(file.path);
    BOOST_TEST_REQUIRE(frames.size() == 2);
    BOOST_TEST(frames[1].step == 50);
    Start const first = balls_of(frames[0]), last = balls_of(frames[1]);
    BOOST_TEST(first.positions(0, 0) == 0.1);
    BOOST_TEST(last.positions(0, 0) == 0.1 + 0.2);
    BOOST_TEST(first.positions(2, 1) == 1.25);
    BOOST_TEST(first.velocities(0, 0) == -1);
    BOOST_TEST(first.velocities(2, 0) == 1e-300);
}

BOOST_AUTO_TEST_CASE(bad_dumps_are_refused_with_their_line) {
    refuse(std::string(two_frames).substr(0, 185), "run.dump:14: the dump is cut short");
    refuse(with(two_frames, "2 1 1.5 1.25 0 0 0", "2 1 1.5 1.25 0 0"), "run.dump:11: \"\" stands");
    refuse(with(two_frames, "1.5", "1.5x"), "run.dump:11: \"1.5x\" stands for number 3 of 7");
    refuse(with(two_frames, "ITEM: BOX", "ITEM: NOX"), "run.dump:5: not \"ITEM: BOX BOUNDS\"");
    refuse(with(two_frames, "ATOMS\n2", "ATOMS\nsome"), "run.dump:4: \"some\" is no whole number");
    BOOST_CHECK_THROW(read_lammps_dump("/nowhere/run.dump"), InputError);
}

BOOST_AUTO_TEST_CASE(balls_out_of_order_or_without_a_column_are_refused) {
    DumpFile const unsorted(with(two_frames, "\n2 1 1.5", "\n3 1 1.5"));
    BOOST_CHECK_THROW(balls_of(read_lammps_dump(unsorted.path).front()), InputError);
    DumpFile const nameless(with(two_frames, "vx", "fx"));
    BOOST_CHECK_THROW(balls_of(read_lammps_dump(nameless.path).front()), InputError);
}

BOOST_AUTO_TEST_CASE(a_pair_collides_when_it_begins_to_touch) {
    auto const seen =
        collisions_seen({contacts(0, {}), contacts(10, {{3, 1}}), contacts(20, {{1, 3}, {2, 4}}),
                         contacts(30, {{2, 4}}), contacts(40, {{1, 3}})});
    BOOST_TEST_REQUIRE(seen.size() == 3);
    BOOST_TEST((seen[0].step == 10 && seen[0].first == 0 && seen[0].second == 2));
    BOOST_TEST((seen[1].step == 20 && seen[1].first == 1 && seen[1].second == 3));
    BOOST_TEST((seen[2].step == 40 && seen[2].first == 0 && seen[2].second == 2));
}

BOOST_AUTO_TEST_CASE(a_data_file_holds_the_start_with_all_its_digits) {
    TemporaryDirectory const directory("lammps_data_test");
    System const system{.side = 1.0 / 3 + 2, .count = 1, .diameter = 1.02};
    Start start{Eigen::Matrix3Xd(3, 1), Eigen::Matrix3Xd(3, 1)};
    start.positions << 0.1 + 0.2, 1, 1;
    start.velocities << -1e-17, 2, 1.0 / 3;
    write_lammps_data(directory.path / "start.data", system, start);
    std::string const text = text_of(directory.path / "start.data");
    for (std::string const part : {"1 atoms\n", "0 2.3333333333333335 xlo xhi\n", "\n1 1 1.02 ",
                                   " 0.30000000000000004 1 1\n",
                                   "\n1 -1.0000000000000001e-17 2 0.33333333333333331 0 0 0\n"})
        BOOST_TEST((text.find(part) != std::string::npos), part << " is not in\n" << text);
    BOOST_CHECK_THROW(write_lammps_data("/nowhere/start.data", system, start), InputError);
}

BOOST_AUTO_TEST_CASE(means_are_the_last_row) {
    DumpFile const file("# Time-averaged data\n# TimeStep a b\n10 1 2\n20 0.5 1.25\n");
    auto const means = read_lammps_means(file.path);
    BOOST_TEST((means == std::vector<double>{0.5, 1.25}));
    DumpFile const empty("# Time-averaged data\n");
    BOOST_CHECK_THROW(read_lammps_means(empty.path), InputError);
}
