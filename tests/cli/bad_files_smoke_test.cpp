#include "tests/cli/program.hpp"

#include "io/trajectory_reader.hpp"

#include <boost/test/unit_test.hpp>

#include <sys/stat.h>

#include <algorithm>
#include <regex>

using namespace clack;
using namespace clack::test;

namespace {

Folder const folder;

std::string const scene = R"(
[container]
boundary = "walls"
side = 12.0
[balls]
count = 64
arrangement = "fcc"
[velocities]
distribution = "maxwell"
[run]
collisions_per_ball = 20
[output]
frame_interval = 0.1
)";

std::string small_scene() { return folder.write("scene.toml", scene); }

/// The user's mistake: exit 2, one line that says so, nothing on standard output, no new file.
void is_refused(std::vector<std::string> const& arguments, std::string const& part,
                std::vector<std::string> const& prefix = {}) {
    auto before = folder.names();
    auto const outcome = run_clack(arguments, prefix);
    BOOST_TEST_CONTEXT(outcome.err) {
        BOOST_TEST(outcome.code == 2);
        BOOST_TEST(outcome.out.empty());
        BOOST_TEST(outcome.err_is_one_line());
        BOOST_TEST(outcome.err.find(part) != std::string::npos);
    }
    auto after = folder.names();
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    BOOST_TEST(before == after, boost::test_tools::per_element());
}

} // namespace

BOOST_AUTO_TEST_CASE(output_that_cannot_be_written_is_refused_before_the_run) {
    auto const path = small_scene();
    for (std::string const form : {"--quiet", "--json"}) {
        is_refused({"run", path, form, "-o", "no/such/folder/out.h5"}, "no folder no/such/folder");
        is_refused({"run", path, form, "-o", "."}, "is a folder");
        is_refused({"run", path, form, "-o", "/dev/null"}, "not an ordinary file");
        is_refused({"run", path, form, "-o", "/proc/out.h5"}, "cannot be written");
        is_refused({"run", path, form, "-o", path}, "is not a trajectory");
    }
}

BOOST_AUTO_TEST_CASE(command_line_is_checked) {
    is_refused({}, "no command");
    is_refused({"fly"}, "fly");
    is_refused({"run"}, "SCENE is required");
    is_refused({"run", small_scene(), "--set"}, "--set");
    is_refused({"run", small_scene(), "--set", "run.seed"}, "run.seed");
    is_refused({"run", small_scene(), "--fast"}, "--fast");
    is_refused({"run", "none.toml"}, "none.toml");
    is_refused({"info", "none.h5"}, "none.h5");
}

BOOST_AUTO_TEST_CASE(file_that_is_not_a_trajectory_of_clack_is_refused) {
    folder.write("text.h5", "not HDF5");
    folder.write("empty.h5", "");
    { auto const bare = hdf5::create_file("bare.h5"); }
    for (std::string const command : {"resume", "check", "export"}) {
        is_refused({command, "none.h5"}, "none.h5: cannot be read");
        is_refused({command, "."}, "cannot be read");
        is_refused({command, "text.h5"}, "not an HDF5 file");
        is_refused({command, "empty.h5"}, "not an HDF5 file");
        is_refused({command, "bare.h5"}, "not H5MD");
    }
    is_refused({"info", "bare.h5"}, "not H5MD");
}

BOOST_AUTO_TEST_CASE(truncated_file_is_refused_wherever_it_ends) {
    BOOST_REQUIRE_EQUAL(run_clack({"run", small_scene(), "-o", "whole.h5", "--quiet"}).code, 0);
    auto const length = std::filesystem::file_size("whole.h5");
    for (std::uintmax_t const bytes :
         {std::uintmax_t{9}, std::uintmax_t{600}, length / 3, length / 2, length - 1}) {
        std::filesystem::copy_file("whole.h5", "part.h5",
                                   std::filesystem::copy_options::overwrite_existing);
        std::filesystem::resize_file("part.h5", bytes);
        is_refused({"resume", "part.h5", "--json"}, "truncated");
        is_refused({"check", "part.h5"}, "truncated");
        is_refused({"export", "part.h5", "-o", "part.xyz"}, "truncated");
    }
}

BOOST_AUTO_TEST_CASE(balls_that_never_meet_are_told_and_leave_no_file) {
    auto const path = folder.write("side_by_side.toml", R"(
[container]
boundary = "periodic"
side = 5.0
[balls]
count = 2
arrangement = "explicit"
positions = [[1, 1, 1], [3, 3, 3]]
[velocities]
distribution = "explicit"
velocities = [[1, 0, 0], [2, 0, 0]]
[run]
collisions = 10
[output]
frame_interval = 0.2
)");
    is_refused({"run", path, "-o", "never.h5", "--json", "--quiet"}, "set time instead");
}

// AddressSanitizer reserves terabytes of address space and keeps what is freed: no program that it
// watches starts under a limit on that, or takes what it does alone.
#ifdef CLACK_SANITIZED
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

BOOST_AUTO_TEST_CASE(memory_is_counted_before_it_is_taken,
                     *boost::unit_test::enable_if<!sanitized>()) {
    // A limit set to the process counts as the machine's memory does: 200 MiB are too little for a
    // million balls.
    std::string million = scene;
    million.replace(million.find("12.0"), 4, "200.0");
    million.replace(million.find("64"), 2, "1000000");
    is_refused({"run", folder.write("million.toml", million), "-o", "million.h5"}, "of memory, and",
               {"sh", "-c", "ulimit -v 204800; exec \"$0\" \"$@\""});
}

/// What a run of the scene takes at its peak, and what `clack info` says that it will.  [bytes]
struct Memory {
    double taken, foretold;
};

Memory memory_of(std::string const& path, std::vector<std::string> const& settings) {
    std::vector<std::string> run{"run", path, "-o", "many.h5", "--quiet"}, info{"info", path};
    for (std::string const& setting : settings)
        for (auto* const arguments : {&run, &info})
            arguments->insert(arguments->end(), {"--set", setting});
    auto const outcome = run_clack(run);
    BOOST_REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
    std::string const said = run_clack(info).out;
    std::smatch number;
    BOOST_REQUIRE(std::regex_search(said, number, std::regex("memory +about (\\S+) MiB of")));
    return {outcome.peak_bytes, std::stod(number[1]) * 0x1p20};
}

// The program's own share is in the figure too: what balls take shows beside a run of fewer. The
// figure leaves a fifth for starts that need more than a lattice.
BOOST_AUTO_TEST_CASE(memory_is_foretold, *boost::unit_test::enable_if<!sanitized>()) {
    std::string timed = scene;
    timed.replace(timed.find("collisions_per_ball = 20"), 24, "collisions = 1000");
    auto const path = folder.write("many.toml", timed);
    for (std::string const side : {"150.0", "65.0"}) { // cells, lists
        for (std::string const boundary : {"walls", "periodic"}) {
            auto const memory = [&](std::string const& count) {
                return memory_of(path, {"container.side=" + side, "container.boundary=" + boundary,
                                        "balls.count=" + count});
            };
            Memory const few = memory("200000"), many = memory("350000");
            BOOST_TEST(many.taken < many.foretold);
            double const part = (many.taken - few.taken) / (many.foretold - few.foretold);
            BOOST_TEST_MESSAGE(part);
            BOOST_TEST(part > 0.78);
            BOOST_TEST(part < 0.95);
        }
    }
}

// A limit on the size of files is what a full disk is to the program: writing fails half-way.
BOOST_AUTO_TEST_CASE(full_disk_is_one_line_and_leaves_a_resumable_file) {
    auto const path = small_scene();
    std::vector<std::string> const many_frames{"--set", "run.collisions_per_ball=400", "--quiet"};
    auto with = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), many_frames.begin(), many_frames.end());
        return arguments;
    };
    BOOST_REQUIRE_EQUAL(run_clack(with({"run", path, "-o", "room.h5", "--json"})).code, 0);
    auto const blocks = std::filesystem::file_size("room.h5") / 512 * 2 / 3;
    auto const limit = "ulimit -f " + std::to_string(blocks) + "; exec \"$0\" \"$@\"";
    auto const full = run_clack(with({"run", path, "-o", "full.h5"}), {"sh", "-c", limit});
    BOOST_TEST_CONTEXT(full.err) {
        BOOST_TEST(full.code == 1);
        BOOST_TEST(full.err_is_one_line());
        BOOST_TEST(full.err.find("full.h5: cannot") != std::string::npos);
        BOOST_TEST(full.err.find("File too large") != std::string::npos);
    }
    TrajectoryReader const left("full.h5");
    BOOST_TEST(left.left_open());
    BOOST_TEST(left.frame_count() > 0u);
    auto const resumed = run_clack({"resume", "full.h5", "--quiet", "--hash"});
    BOOST_TEST(resumed.code == 0);
    auto const hash = resumed.out.substr(resumed.out.find("hash ") + 22, 16);
    auto const untouched = run_clack({"resume", "room.h5", "--json"}).out;
    BOOST_TEST(untouched.find(hash) != std::string::npos, hash + " in " + untouched);
    // No room even for the start: no file at all.
    auto const none = run_clack(with({"run", path, "-o", "none.h5"}),
                                {"sh", "-c", "ulimit -f 8; exec \"$0\" \"$@\""});
    BOOST_TEST(none.code == 1);
    BOOST_TEST(none.err_is_one_line());
    BOOST_TEST(!std::filesystem::exists("none.h5"));
    BOOST_TEST(!std::filesystem::exists(".none.h5.partial"));
}

BOOST_AUTO_TEST_CASE(leftover_of_a_failed_start_is_removed) {
    folder.write(".out.h5.partial", "left by a kill");
    BOOST_REQUIRE_EQUAL(run_clack({"run", small_scene(), "-o", "out.h5", "--quiet"}).code, 0);
    BOOST_TEST(!std::filesystem::exists(".out.h5.partial"));
}
