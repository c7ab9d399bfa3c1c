#include "tests/cli/program.hpp"
#include "tests/cli/same_file.hpp"

#include "cli/record.hpp"

#include <boost/test/unit_test.hpp>

#include <random>

using namespace clack;
using namespace clack::test;
using std::chrono::microseconds;

namespace {

Folder const folder;

std::string const scene = R"(
[container]
boundary = "periodic"
packing_fraction = 0.3
[balls]
count = 108
arrangement = "fcc"
[velocities]
distribution = "maxwell"
[run]
seed = 7
equilibrate = 200
collisions_per_ball = 1200
[output]
frame_interval = 0.5
events = true
)";

Outcome run(std::string const& output, std::vector<std::string> arguments = {}) {
    arguments.insert(arguments.begin(),
                     {"run", folder.write("scene.toml", scene), "-o", output, "--quiet", "--json"});
    return run_clack(arguments);
}

Outcome resume(std::string const& file, std::vector<std::string> arguments = {}) {
    arguments.insert(arguments.begin(), {"resume", file, "--quiet", "--json"});
    return run_clack(arguments);
}

/// How long the whole run takes here and now.
microseconds duration_of_reference() {
    static microseconds const duration = [] {
        auto const begin = std::chrono::steady_clock::now();
        BOOST_REQUIRE_EQUAL(run("reference.h5").code, 0);
        return std::chrono::duration_cast<microseconds>(std::chrono::steady_clock::now() - begin);
    }();
    return duration;
}

/// Starts a run, sends it a signal somewhere on its way, and its resumption too, and lets a third
/// process finish. Says what differs from the run that was left alone.
std::string difference_after(int signal, std::mt19937_64& moments) {
    auto const whole = duration_of_reference();
    auto const some_time = [&] {
        auto const share = static_cast<double>(moments() >> 11) * 0x1p-53;
        // Not before the process has had time to say what signals do.
        return microseconds(50'000 + static_cast<long>(share * static_cast<double>(whole.count())));
    };
    std::filesystem::remove("stopped.h5");
    Process first({"run", "scene.toml", "-o", "stopped.h5", "--quiet"});
    if (signal != SIGKILL) first.wait_for("stopped.h5");
    first.signal_after(some_time(), signal);
    auto const code = first.finish().code;
    BOOST_TEST((code == 0 || code == (signal == SIGKILL ? -SIGKILL : 130)));
    if (signal != SIGKILL) BOOST_TEST(!std::filesystem::exists(".stopped.h5.partial"));
    if (!std::filesystem::exists("stopped.h5")) return signal == SIGKILL ? "" : "no file";
    Process second({"resume", "stopped.h5", "--quiet"});
    second.signal_after(some_time() / 2, signal);
    second.finish();
    auto const third = resume("stopped.h5");
    BOOST_TEST(third.code == 0);
    BOOST_TEST(!std::filesystem::exists(".stopped.h5.partial"));
    return difference("reference.h5", "stopped.h5");
}

} // namespace

BOOST_AUTO_TEST_CASE(killed_run_goes_on_to_the_same_bits) {
    std::mt19937_64 moments(2015);
    for (int k = 0; k < 3; ++k) BOOST_TEST(difference_after(SIGKILL, moments) == "");
}

BOOST_AUTO_TEST_CASE(interrupted_run_closes_its_file_and_goes_on_to_the_same_bits) {
    std::mt19937_64 moments(2016);
    BOOST_TEST(difference_after(SIGINT, moments) == "");
    BOOST_TEST(difference_after(SIGTERM, moments) == "");
}

/// A signal that comes while the file's head is written finds the file under its first name. Ten
/// times, for some come too late.
BOOST_AUTO_TEST_CASE(interrupt_while_the_file_is_made_leaves_no_part_of_it) {
    duration_of_reference();
    std::string const part = ".made.h5.partial";
    for (int k = 0; k < 10; ++k) {
        std::filesystem::remove("made.h5");
        Process first({"run", "scene.toml", "-o", "made.h5", "--quiet", "--set",
                       "run.collisions_per_ball=1e7"});
        std::error_code absent;
        for (std::uintmax_t bytes = 0; bytes == 0 || bytes == static_cast<std::uintmax_t>(-1);) {
            bytes = std::filesystem::file_size(part, absent);
            if (std::filesystem::exists("made.h5")) break;
        }
        first.signal_after(microseconds(0), SIGINT);
        auto const outcome = first.finish();
        BOOST_TEST(outcome.code == 130);
        BOOST_TEST(!std::filesystem::exists(part));
        BOOST_TEST(outcome.err.find("clack resume made.h5") != std::string::npos);
    }
}

BOOST_AUTO_TEST_CASE(interrupted_equilibration_is_resumable) {
    duration_of_reference();
    Process first(
        {"run", "scene.toml", "-o", "early.h5", "--quiet", "--set", "run.equilibrate=1000000"});
    first.wait_for("early.h5");
    first.signal_after(microseconds(100'000), SIGINT);
    auto const outcome = first.finish();
    BOOST_TEST(outcome.code == 130);
    BOOST_TEST(outcome.err_is_one_line());
    BOOST_TEST(outcome.err.find("clack resume early.h5") != std::string::npos);
    TrajectoryReader const file("early.h5");
    BOOST_TEST(!file.left_open());
    BOOST_TEST(file.frame_count() == 0u);
    BOOST_TEST((file.resume_point().phase == Phase::equilibrating));
    BOOST_TEST(file.resume_point().engine.tallies.ball_collisions > 0u);
}

BOOST_AUTO_TEST_CASE(extended_run_is_the_longer_run) {
    duration_of_reference();
    for (std::string const goal : {"run.collisions_per_ball=311", "run.collisions=20000"}) {
        BOOST_REQUIRE_EQUAL(run("short.h5", {"--set", "run.collisions_per_ball=100"}).code, 0);
        BOOST_REQUIRE_EQUAL(run("long.h5", {"--set", goal}).code, 0);
        BOOST_REQUIRE_EQUAL(resume("short.h5", {"--set", goal}).code, 0);
        BOOST_TEST(difference("short.h5", "long.h5") == "");
    }
    BOOST_REQUIRE_EQUAL(run("short.h5", {"--set", "run.time=3.3"}).code, 0);
    BOOST_REQUIRE_EQUAL(run("long.h5", {"--set", "run.time=40"}).code, 0);
    BOOST_REQUIRE_EQUAL(resume("short.h5", {"--set", "run.time=40"}).code, 0);
    BOOST_TEST(difference("short.h5", "long.h5") == "");
}

BOOST_AUTO_TEST_CASE(any_method_goes_on_to_the_same_bits) {
    duration_of_reference();
    for (std::string const precision : {"double", "float", "long double", "quad"}) {
        std::vector<std::string> const also{"--set", "run.precision=" + precision, "--set",
                                            "run.equilibrate=3"};
        auto with_goal = [&](std::string const& goal, std::string const& method) {
            auto all = also;
            all.insert(all.end(), {"--set", goal, "--set", "run.method=" + method});
            return all;
        };
        BOOST_REQUIRE_EQUAL(run("one.h5", with_goal("run.collisions=1000", "heap")).code, 0);
        BOOST_REQUIRE_EQUAL(run("whole.h5", with_goal("run.collisions=3000", "fast")).code, 0);
        BOOST_REQUIRE_EQUAL(
            resume("one.h5", {"--set", "run.collisions=2000", "--set", "run.method=table"}).code,
            0);
        BOOST_REQUIRE_EQUAL(
            resume("one.h5", {"--set", "run.collisions=3000", "--set", "run.method=fast"}).code, 0);
        BOOST_TEST(difference("one.h5", "whole.h5") == "", precision);

        BOOST_REQUIRE_EQUAL(run("one.h5", with_goal("run.time=0.3", "heap")).code, 0);
        BOOST_REQUIRE_EQUAL(run("whole.h5", with_goal("run.time=0.7", "fast")).code, 0);
        BOOST_TEST(resume("one.h5").err.find("is finished") != std::string::npos);
        BOOST_REQUIRE_EQUAL(resume("one.h5", {"--set", "run.time=0.7"}).code, 0);
        BOOST_TEST(difference("one.h5", "whole.h5") == "", precision);
    }
}

BOOST_AUTO_TEST_CASE(finished_run_says_so_and_a_changed_run_is_refused) {
    duration_of_reference();
    BOOST_REQUIRE_EQUAL(run("done.h5", {"--set", "run.collisions_per_ball=10"}).code, 0);
    auto const before = text_of("done.h5");
    auto const again = resume("done.h5");
    BOOST_TEST(again.code == 0);
    BOOST_TEST(again.err.find("is finished") != std::string::npos);
    BOOST_TEST(again.out.find("\"hash\"") != std::string::npos);
    for (std::string const change :
         {"run.seed=8", "container.side=30", "balls.mass=2", "output.frame_interval=1",
          "run.precision=float", "nonsense"}) {
        auto const refused = resume("done.h5", {"--set", change});
        BOOST_TEST(refused.code == 2);
        BOOST_TEST(refused.out.empty());
        BOOST_TEST(refused.err_is_one_line());
        BOOST_TEST(refused.err.find(change) != std::string::npos);
    }
    BOOST_TEST(text_of("done.h5") == before);
}

BOOST_AUTO_TEST_CASE(finished_run_that_was_killed_before_it_closed_its_file_is_closed) {
    auto const brief =
        read_scene(folder.write("scene.toml", scene), {"run.collisions_per_ball=10"});
    auto const engine = make_engine(brief.system, brief.method, brief.precision, make_start(brief));
    TrajectoryWriter writer("closed.h5", header_of(brief, *engine));
    ProgressLine line(Progress::hidden);
    RecordedRun whole(brief, *engine, writer, line);
    BOOST_TEST((whole.run() == RecordedRun::End::finished));
    std::filesystem::copy_file("closed.h5", "left.h5"); // what a kill now would leave
    writer.close();
    BOOST_TEST(TrajectoryReader("left.h5").left_open());
    BOOST_TEST(resume("left.h5").code == 0);
    BOOST_TEST(!TrajectoryReader("left.h5").left_open());
    BOOST_TEST(difference("left.h5", "closed.h5") == "");
}

BOOST_AUTO_TEST_CASE(link_stays_a_link) {
    duration_of_reference();
    std::filesystem::create_symlink("behind.h5", "link.h5");
    BOOST_REQUIRE_EQUAL(run("link.h5", {"--set", "run.collisions_per_ball=10"}).code, 0);
    BOOST_REQUIRE_EQUAL(resume("link.h5", {"--set", "run.collisions_per_ball=20"}).code, 0);
    BOOST_TEST(std::filesystem::is_symlink("link.h5"));
    BOOST_TEST(TrajectoryReader("behind.h5").resume_point().engine.tallies.ball_collisions ==
               1080u);
}

BOOST_AUTO_TEST_CASE(file_that_is_being_written_is_read_but_not_resumed) {
    duration_of_reference();
    Process writer(
        {"run", "scene.toml", "-o", "busy.h5", "--quiet", "--set", "run.collisions_per_ball=1e7"});
    for (int k = 0; k < 200 && !std::filesystem::exists("busy.h5"); ++k) {
        std::this_thread::sleep_for(microseconds(50'000));
    }
    auto const refused = resume("busy.h5");
    BOOST_TEST(refused.code == 2);
    BOOST_TEST(refused.err.find("another process is writing it") != std::string::npos);
    BOOST_TEST(run("busy.h5").code == 2);
    BOOST_TEST(run_clack({"info", "busy.h5"}).code == 0);
    BOOST_TEST(TrajectoryReader("busy.h5").left_open());
    writer.signal_after(microseconds(0), SIGINT);
    BOOST_TEST(writer.finish().code == 130);
}
