#include "reference/lammps.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace clack::reference {

namespace {

constexpr char const* log_name = "lammps.log";

std::string text_of(std::filesystem::path const& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string program_name() {
    char const* const named = std::getenv("CLACK_LAMMPS"); // NOLINT(concurrency-mt-unsafe)
    return named && *named ? named : "lmp";
}

/// One process needs neither a daemon nor networks: it takes Open MPI ten times as long as most
/// jobs to find that out for itself. Nobody else minds.
constexpr char const* alone[] = {"OMPI_MCA_ess_singleton_isolated=1", "OMPI_MCA_btl=self",
                                 "OMPI_MCA_pml=ob1", "OMP_NUM_THREADS=1"};

/// The variables of this process with those in front.
std::vector<char*> environment_of(std::vector<std::string>& own) {
    own.assign(std::begin(alone), std::end(alone));
    std::vector<char*> all;
    for (std::string& variable : own) all.push_back(variable.data());
    for (char** variable = environ; *variable; ++variable) all.push_back(*variable);
    all.push_back(nullptr);
    return all;
}

/// The decks of all jobs in one input.
std::string input_of(std::string const& deck, std::vector<LammpsJob> const& jobs) {
    std::string input;
    for (LammpsJob const& job : jobs) {
        for (auto const& [name, value] : job)
            input += fmt::format("variable {} string {}\n", name, value);
        input += deck + '\n';
    }
    return input;
}

/// Runs a program in a folder with its output thrown away; what waitpid says of its end.
int status_of(std::string const& program, std::vector<std::string> arguments,
              std::filesystem::path const& folder) {
    std::vector<char*> argv;
    arguments.insert(arguments.begin(), program);
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    std::vector<std::string> own;
    std::vector<char*> const environment = environment_of(own);
    pid_t child = 0;
    int const failure =
        posix_spawnp(&child, program.c_str(), &actions, nullptr, argv.data(), environment.data());
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) {
        throw LammpsError(
            LammpsFailure::missing,
            fmt::format("{}: cannot be run ({}): install the Debian package lammps, or "
                        "name the program in CLACK_LAMMPS",
                        program, std::strerror(failure))); // NOLINT(concurrency-*)
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

/// What a log tells.
struct Report {
    std::string version; // empty: the log does not begin as LAMMPS begins its logs
    std::string error;   // the first line with an error
    int runs = 0;        // that came to their end
    long dangerous_builds = 0;
};

Report report_of(std::string const& log) {
    constexpr std::string_view head = "LAMMPS (", dangerous = "Dangerous builds = ";
    Report report;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        if (report.version.empty() && line.starts_with(head))
            report.version = line.substr(head.size(), line.rfind(')') - head.size());
        if (report.error.empty() && line.find("ERROR") != std::string::npos) report.error = line;
        if (line.starts_with("Loop time of")) ++report.runs;
        if (line.starts_with(dangerous))
            report.dangerous_builds += std::strtol(line.c_str() + dangerous.size(), nullptr, 10);
    }
    return report;
}

std::string words_for(int const status) {
    if (WIFSIGNALED(status)) return fmt::format("was killed by signal {}", WTERMSIG(status));
    return fmt::format("ended with exit code {}", WEXITSTATUS(status));
}

/// Throws for what went wrong, the cause before its consequences.
void check(std::string const& program, Report const& report, int const status,
           std::size_t const jobs, int const runs_expected) {
    auto const fail = [&](LammpsFailure const why, std::string const& line) {
        throw LammpsError(why, program + ": " + line);
    };
    std::string const where = fmt::format("in run {} of {}", report.runs + 1, runs_expected);
    if (!report.version.empty() && !report.version.starts_with(lammps_version)) {
        fail(LammpsFailure::other_version,
             fmt::format("is LAMMPS of {}, and the decks are known to be right with that of {}: "
                         "install Debian 12's package lammps, or name another program in "
                         "CLACK_LAMMPS",
                         report.version, lammps_version));
    }
    if (report.error.find("Lost atoms") != std::string::npos) {
        fail(LammpsFailure::lost_atoms,
             fmt::format("{} {}: a contact lasts too few steps, or a ball was too fast for the "
                         "stiffness; shorten dt or raise k",
                         report.error, where));
    }
    if (!report.error.empty() || status != 0 || report.version.empty() ||
        report.runs != runs_expected) {
        fail(LammpsFailure::broke_off,
             fmt::format("{} {}{}", words_for(status), where,
                         report.error.empty() ? " without a word why" : ": " + report.error));
    }
    if (report.dangerous_builds > 0) {
        fail(
            LammpsFailure::dangerous_builds,
            fmt::format("{} dangerous builds of neighbour lists in {} jobs: contacts may have been "
                        "missed; look at neigh_modify in the deck",
                        report.dangerous_builds, jobs));
    }
}

int runs_of(std::string const& deck) {
    int runs = 0;
    std::istringstream lines(deck);
    for (std::string line; std::getline(lines, line);) runs += line.starts_with("run ");
    return runs;
}

} // namespace

std::string lammps_deck(std::string const& file_name) {
    std::filesystem::path const path = std::filesystem::path(CLACK_REFERENCE_DIR) / file_name;
    std::string deck = text_of(path);
    if (deck.empty()) throw InputError(path.string() + ": cannot be read, or is empty");
    return deck;
}

LammpsFolder::LammpsFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "clack_lammps_XXXXXX").string();
    if (!mkdtemp(name.data()))
        throw InputError(name + ": cannot be made; name a folder with room for it in TMPDIR");
    path_ = name;
}

LammpsFolder::~LammpsFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

void run_lammps(LammpsFolder const& folder, std::string const& deck,
                std::vector<LammpsJob> const& jobs) {
    std::string const program = program_name();
    std::filesystem::path const input = folder / "lammps.in", log = folder / log_name;
    std::filesystem::remove(log);
    std::ofstream file(input);
    file << input_of(deck, jobs) << std::flush;
    if (!file) throw InputError(input.string() + ": cannot be written; is the disk full?");
    int const status =
        status_of(program, {"-in", "lammps.in", "-log", log_name, "-screen", "none", "-nocite"},
                  folder.path());
    check(program, report_of(text_of(log)), status, jobs.size(),
          runs_of(deck) * static_cast<int>(jobs.size()));
}

} // namespace clack::reference
