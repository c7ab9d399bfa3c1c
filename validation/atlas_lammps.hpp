#pragma once
// LAMMPS as a column of the failure atlas: soft balls at one stiffness.

#include "reference/lammps.hpp"
#include "reference/lammps_files.hpp"
#include "reference/soft_balls.hpp"
#include "validation/atlas_checks.hpp"

#include "validation/records/campaign.hpp"

#include <fmt/format.h>

#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace clack::validation::atlas {

/// A problem for soft balls of one stiffness.
struct SoftProblem {
    Problem problem;
    double stiffness;

    static constexpr double steps_per_contact = 20;

    double steps() const {
        double const contacts =
            problem.times.back() / reference::contact_duration(stiffness) * steps_per_contact;
        auto const looks = static_cast<double>(problem.times.size());
        return looks * std::max(1.0, std::ceil(contacts / looks));
    }

    /// No deck turns balls round, that of walls would fill the memory with the cells of a wide
    /// cube, and what takes longer than seconds is left out too.
    Absence absence() const {
        constexpr double walled_side_max = 120, work_max = 4e6;
        double const work = steps() * static_cast<double>(problem.system.count + 20);
        if (problem.turns_round) return Absence::turns_round;
        if (problem.system.boundary == Boundary::walls && problem.system.side > walled_side_max)
            return Absence::too_wide;
        return problem.has_reference && work <= work_max ? Absence::none : Absence::too_long;
    }

    reference::LammpsJob job(std::string const& name) const {
        auto const number = [](double value) { return fmt::format("{:.17g}", value); };
        return {{"data", name + ".data"},
                {"side", number(problem.system.side)},
                {"k", number(stiffness)},
                {"kw", number(2 * stiffness)},
                {"dt", number(problem.times.back() / steps())},
                {"steps", number(steps())},
                {"every", number(steps() / static_cast<double>(problem.times.size()))},
                {"dump", name + ".dump"},
                {"contacts_every", number(steps_per_contact / 4)},
                {"contacts", name + ".contacts"}};
    }

    Trace trace(reference::LammpsFolder const& folder, std::string const& name) const {
        Trace trace;
        auto const frames = reference::read_lammps_dump(folder / (name + ".dump"));
        for (std::size_t k = 1; k < frames.size(); ++k) {
            Start const balls = reference::balls_of(frames[k]);
            trace.frames.push_back({balls.positions, balls.velocities});
        }
        for (auto const& seen :
             reference::collisions_seen(reference::read_lammps_dump(folder / (name + ".contacts"))))
            trace.meetings.emplace_back(seen.first, seen.second);
        trace.collisions_per_ball = 2 * static_cast<double>(trace.meetings.size()) /
                                    static_cast<double>(problem.system.count);
        return trace;
    }
};

/// What LAMMPS makes of problems; nothing of those it cannot run, and of none where it is missing.
class SoftBalls {
public:
    /// Says in one line why there is none, where there is none.
    SoftBalls() {
        try {
            reference::run_lammps(reference::LammpsFolder(), walled_deck_, {});
        } catch (reference::LammpsError const& error) {
            std::cout << error.what() << '\n';
            there_ = false;
        }
    }

    /// What a campaign's rows depend on: those without LAMMPS are no memory for those with it.
    std::string name() const {
        return there_ ? fmt::format("lammps={:016x}", hash_of(walled_deck_ + periodic_deck_))
                      : "lammps=none";
    }
    /// Why a problem is not run.
    Absence absence(SoftProblem const& problem) const {
        return there_ ? problem.absence() : Absence::missing;
    }
    std::vector<std::optional<Trace>> fly(std::vector<SoftProblem> const& problems) {
        std::vector<std::optional<Trace>> traces(problems.size());
        for (Boundary const boundary : {Boundary::walls, Boundary::periodic}) {
            Some runnable; // by one deck
            for (std::size_t k = 0; k < problems.size(); ++k)
                if (problems[k].problem.system.boundary == boundary &&
                    absence(problems[k]) == Absence::none)
                    runnable.push_back(k);
            if (!runnable.empty()) run(problems, runnable, traces);
        }
        return traces;
    }

private:
    using Some = std::vector<std::size_t>;

    /// All in one process; when one of them fails, the halves by themselves.
    void run(std::vector<SoftProblem> const& problems, Some const& some,
             std::vector<std::optional<Trace>>& traces) {
        try {
            run_together(problems, some, traces);
        } catch (reference::LammpsError const& error) {
            if (some.size() == 1) {
                Trace failed;
                failed.end = end_of(error.failure);
                traces[some.front()] = failed;
            } else {
                auto const middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
                run(problems, {some.begin(), middle}, traces);
                run(problems, {middle, some.end()}, traces);
            }
        }
    }

    static End end_of(reference::LammpsFailure const failure) {
        using enum reference::LammpsFailure;
        // Balls too fast for their lists of neighbours pass through each other.
        return failure == lost_atoms         ? End::lost
               : failure == dangerous_builds ? End::overlap
                                             : End::crash;
    }

    void run_together(std::vector<SoftProblem> const& problems, Some const& some,
                      std::vector<std::optional<Trace>>& traces) const {
        reference::LammpsFolder const folder;
        std::vector<reference::LammpsJob> jobs;
        for (std::size_t const k : some) {
            Problem const& problem = problems[k].problem;
            std::string const name = std::to_string(k);
            reference::write_lammps_data(folder / (name + ".data"), problem.system, problem.start);
            jobs.push_back(problems[k].job(name));
        }
        bool const walls = problems[some.front()].problem.system.boundary == Boundary::walls;
        reference::run_lammps(folder, walls ? walled_deck_ : periodic_deck_, jobs);
        for (std::size_t const k : some) traces[k] = problems[k].trace(folder, std::to_string(k));
    }

    std::string walled_deck_ = reference::lammps_deck("lammps_cube.in");
    std::string periodic_deck_ = reference::lammps_deck("lammps_periodic_paths.in");
    bool there_ = true;
};

} // namespace clack::validation::atlas
