// The decks, run by LAMMPS itself. Skipped where it is not installed.

#include "reference/lammps.hpp"
#include "reference/lammps_files.hpp"
#include "reference/soft_balls.hpp"
#include "tests/reference/needs_lammps.hpp"

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>

using namespace clack;
using namespace clack::reference;

namespace {

constexpr double stiffness = 1e6;
System const system_of_two{.side = 4, .count = 2};

/// Two balls that meet head-on at time 1/4, one of them on its way to a wall.
Start two_balls() {
    Start start{Eigen::Matrix3Xd(3, 2), Eigen::Matrix3Xd(3, 2)};
    start.positions.col(0) = Eigen::Vector3d(1.0 + 1.0 / 3, 2, 2);
    start.positions.col(1) = Eigen::Vector3d(2.0 + 1.0 / 3 + 0.5, 2, 2);
    start.velocities.col(0) = Eigen::Vector3d(1, 0, 0);
    start.velocities.col(1) = Eigen::Vector3d(-1, 0, 0);
    return start;
}

LammpsJob job_of(double const time, double const steps_per_contact) {
    double const dt = contact_duration(stiffness) / steps_per_contact;
    auto const steps = static_cast<std::int64_t>(time / dt);
    return {{"data", "start.data"},
            {"side", "4"},
            {"k", fmt::format("{}", stiffness)},
            {"kw", fmt::format("{}", 2 * stiffness)},
            {"dt", fmt::format("{:.17g}", time / static_cast<double>(steps))},
            {"steps", fmt::format("{}", steps)},
            {"every", fmt::format("{}", steps)},
            {"dump", "run.dump"},
            {"contacts_every", "10"},
            {"contacts", "run.contacts"}};
}

} // namespace

BOOST_AUTO_TEST_CASE(soft_balls_meet_head_on, *NeedsLammps()) {
    LammpsFolder const folder;
    Start const start = two_balls();
    write_lammps_data(folder / "start.data", system_of_two, start);
    run_lammps(folder, lammps_deck("lammps_cube.in"), {job_of(0.5, 100)});
    auto const frames = read_lammps_dump(folder / "run.dump");
    BOOST_TEST_REQUIRE(frames.size() == 2);
    Start const first = balls_of(frames.front()), last = balls_of(frames.back());
    BOOST_TEST((first.positions == start.positions)); // to the last bit
    BOOST_TEST((first.velocities == start.velocities));
    // They turn round a contact's normal speed, 2, times half its duration nearer than hard balls.
    double const lag = stepped_contact_duration(stiffness, 100);
    BOOST_TEST(std::abs(last.velocities(0, 0) + 1) < 5e-6);
    BOOST_TEST(std::abs(last.positions(0, 0) - start.positions(0, 0) - lag) < 5e-6);
    auto const seen = collisions_seen(read_lammps_dump(folder / "run.contacts"));
    BOOST_TEST_REQUIRE(seen.size() == 1);
    BOOST_TEST(seen[0].first == 0);
    BOOST_TEST(seen[0].second == 1);
}

BOOST_AUTO_TEST_CASE(one_step_a_contact_loses_the_balls, *NeedsLammps()) {
    LammpsFolder const folder;
    write_lammps_data(folder / "start.data", system_of_two, two_balls());
    BOOST_CHECK_EXCEPTION(run_lammps(folder, lammps_deck("lammps_cube.in"), {job_of(20, 1)}),
                          LammpsError, [](LammpsError const& error) {
                              BOOST_TEST_MESSAGE(error.what());
                              return error.failure == LammpsFailure::lost_atoms;
                          });
}

BOOST_AUTO_TEST_CASE(dilute_soft_balls_have_the_pressure_of_an_ideal_gas, *NeedsLammps()) {
    LammpsFolder const folder;
    System const wide{.boundary = Boundary::periodic, .side = 8, .count = 2};
    write_lammps_data(folder / "start.data", wide, two_balls());
    run_lammps(folder, lammps_deck("lammps_periodic.in"),
               {{{"data", "start.data"},
                 {"k", "1e4"},
                 {"dt", "0.001"},
                 {"before", "10"},
                 {"steps", "50"}, // they do not meet that soon
                 {"means", "run.means"}}});
    auto const means = read_lammps_means(folder / "run.means");
    BOOST_TEST_REQUIRE(means.size() == 2);
    BOOST_TEST(std::abs(means[1] - 2.0 / 3) < 1e-12);                  // kT = 2E / (3N - 3)
    BOOST_TEST(std::abs(means[0] * 512 / means[1] - (2 - 1)) < 1e-12); // P V = (N - 1) kT
}
