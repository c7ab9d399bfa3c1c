// What is said when LAMMPS is missing, another, or fails: a shell script stands in for it.

#include "reference/lammps.hpp"

#include <boost/test/unit_test.hpp>

#include <cstdlib>
#include <fstream>
#include <iterator>

using namespace clack::reference;

namespace {

constexpr char const* good_head = "LAMMPS (29 Sep 2021 - Update 2)\n";
constexpr char const* good_run = "Loop time of 1.5 on 1 procs\nDangerous builds = 0\n";

/// Stands in for lmp as long as it lives: leaves a log and an exit code.
class FakeLammps {
public:
    FakeLammps(std::string const& log, std::string const& end) {
        auto const program = folder_ / "lmp";
        std::ofstream(program) << "#!/bin/sh\ncat > lammps.log <<'LOG'\n"
                               << log << "LOG\n"
                               << end << '\n';
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
        setenv("CLACK_LAMMPS", program.c_str(), 1);
    }
    ~FakeLammps() { unsetenv("CLACK_LAMMPS"); }
    FakeLammps(FakeLammps const&) = delete;
    FakeLammps& operator=(FakeLammps const&) = delete;

private:
    LammpsFolder folder_;
};

struct Outcome {
    LammpsFailure failure;
    std::string line;
};

Outcome outcome() {
    try {
        run_lammps(LammpsFolder(), "run ${steps}\n", {{{"steps", "3"}}, {{"steps", "4"}}});
    } catch (LammpsError const& error) {
        return {error.failure, error.what()};
    }
    BOOST_FAIL("no error");
    return {};
}

void expect(LammpsFailure const failure, std::string const& words) {
    auto const [found, line] = outcome();
    BOOST_TEST((found == failure), line);
    BOOST_TEST((line.find(words) != std::string::npos), line);
    BOOST_TEST((line.find('\n') == std::string::npos), line);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_good_run_passes_and_gets_its_variables) {
    FakeLammps const fake(std::string(good_head) + good_run + good_run, "exit 0");
    LammpsFolder const folder;
    run_lammps(folder, "run ${steps}\n", {{{"steps", "3"}}, {{"steps", "4"}}});
    std::ifstream file(folder / "lammps.in");
    std::string const input{std::istreambuf_iterator<char>(file), {}};
    BOOST_TEST(input == "variable steps string 3\nrun ${steps}\n\n"
                        "variable steps string 4\nrun ${steps}\n\n");
}

BOOST_AUTO_TEST_CASE(a_missing_program_is_told_with_the_package_that_has_it) {
    setenv("CLACK_LAMMPS", "/nowhere/lmp", 1);
    expect(LammpsFailure::missing, "install the Debian package lammps");
    unsetenv("CLACK_LAMMPS");
}

BOOST_AUTO_TEST_CASE(another_version_is_told_before_what_it_stumbles_over) {
    FakeLammps const fake("LAMMPS (2 Aug 2023)\nERROR: Unknown fix style\n", "exit 1");
    expect(LammpsFailure::other_version, "is LAMMPS of 2 Aug 2023");
}

BOOST_AUTO_TEST_CASE(lost_atoms_are_told_with_the_run_that_lost_them) {
    FakeLammps const fake(std::string(good_head) + good_run +
                              "ERROR: Lost atoms: original 27 current 26 (src/thermo.cpp:438)\n",
                          "exit 1");
    expect(LammpsFailure::lost_atoms, "in run 2 of 2: a contact lasts too few steps");
}

BOOST_AUTO_TEST_CASE(dangerous_builds_are_told_though_the_run_succeeds) {
    FakeLammps const fake(
        std::string(good_head) + good_run + "Loop time of 1.5\nDangerous builds = 7\n", "exit 0");
    expect(LammpsFailure::dangerous_builds, "7 dangerous builds");
}

BOOST_AUTO_TEST_CASE(other_errors_are_handed_on) {
    FakeLammps const fake(std::string(good_head) + "ERROR: Illegal run command\n", "exit 1");
    expect(LammpsFailure::broke_off,
           "ended with exit code 1 in run 1 of 2: ERROR: Illegal run command");
}

BOOST_AUTO_TEST_CASE(a_run_that_stops_early_without_an_error_is_told) {
    FakeLammps const fake(std::string(good_head) + good_run, "exit 0");
    expect(LammpsFailure::broke_off, "in run 2 of 2 without a word why");
}

BOOST_AUTO_TEST_CASE(a_kill_is_told) {
    FakeLammps const fake(good_head, "kill -9 $$");
    expect(LammpsFailure::broke_off, "was killed by signal 9");
}

BOOST_AUTO_TEST_CASE(a_program_that_is_not_lammps_is_told) {
    FakeLammps const fake("", "exit 0");
    expect(LammpsFailure::broke_off, "without a word why");
}

BOOST_AUTO_TEST_CASE(decks_are_found_beside_the_reference) {
    BOOST_TEST(lammps_deck("lammps_cube.in").find("fix             motion all nve/sphere") !=
               std::string::npos);
    BOOST_CHECK_THROW(lammps_deck("no_such_deck.in"), clack::InputError);
}

BOOST_AUTO_TEST_CASE(a_folder_goes_with_its_object) {
    std::filesystem::path path;
    {
        LammpsFolder const folder;
        path = folder.path();
        BOOST_TEST(std::filesystem::is_directory(path));
    }
    BOOST_TEST(!std::filesystem::exists(path));
}
