#pragma once
// The methods of the failure atlas: clack's own, in two precisions, what is written instead of
// them, and what textbooks make of the engine.

#include "reference/frame_stepping.hpp"
#include "reference/textbook_engines.hpp"
#include "simulation/model_choice.hpp"
#include "validation/atlas_checks.hpp"
#include "validation/child_process.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace clack::validation::atlas {

/// A column of the atlas.
struct Contender {
    enum class Family { clack_float, clack_double, frames, textbook, lammps };
    std::string name;
    Family family;
    std::function<Absence(Problem const&)> absence{}; // why a problem is not for it
    std::function<Trace(Problem const&)> fly{};       // LAMMPS has its own way
    double stiffness = 0;                             // LAMMPS

    double roundoff() const {
        return family == Family::clack_float ? float_roundoff : double_roundoff;
    }
};

/// All but the fast method leave the longest run out: they would go the same way to the last bit.
inline Absence unless_fast_alone(Problem const& problem) {
    return problem.fast_alone ? Absence::too_long : Absence::none;
}
inline Absence never_absent(Problem const&) { return Absence::none; }

inline Contender clack_method(Method const method, Precision const precision) {
    Maker const make = [=](System const& system, Checkpoint const& checkpoint) {
        return make_engine(system, method, precision, checkpoint);
    };
    bool const single = precision == Precision::single_;
    return {std::string(name_of(method)) + ' ' + name_of(precision),
            single ? Contender::Family::clack_float : Contender::Family::clack_double,
            method == Method::fast ? never_absent : unless_fast_alone,
            [=](Problem const& problem) { return fly(problem, make, precision); }};
}

inline Contender textbook_rule(reference::Textbook const rule, std::string const& name) {
    Maker const make = [=](System const& system, Checkpoint const& checkpoint) {
        return reference::make_textbook_engine(rule, system, checkpoint);
    };
    return {name, Contender::Family::textbook, unless_fast_alone,
            [=](Problem const& problem) { return fly(problem, make, Precision::double_); }};
}

/// Steps of a hundredth of a diameter at the speed of most balls, as a game would choose them;
/// so many between two looks at the balls.
inline double frames_between_looks(Problem const& problem) {
    double const dt = 0.01 * problem.system.diameter / problem.speed();
    return std::max(std::ceil(problem.times.front() / dt), 8.0);
}
inline Absence absence_of_frames(Problem const& problem) {
    constexpr double cells = 27, work_max = 3e7; // pairs and cells looked at
    auto const count = static_cast<double>(problem.system.count);
    double const steps = frames_between_looks(problem) * static_cast<double>(problem.times.size());
    return steps * count * (cells + count) > work_max ? Absence::too_long : Absence::none;
}
inline Trace step_frames(Problem const& problem) {
    auto const count = static_cast<double>(problem.system.count);
    double const steps = frames_between_looks(problem), step = problem.times.front() / steps;
    Trace trace;
    Start balls = problem.start;
    for (std::size_t k = 0; k < problem.times.size(); ++k) {
        reference::FrameStepping stepping(problem.system, balls, step);
        stepping.advance(static_cast<std::int64_t>(steps));
        balls = stepping.balls();
        trace.frames.push_back({balls.positions, balls.velocities});
        for (auto const& pair : stepping.pairs()) trace.meetings.emplace_back(pair[0], pair[1]);
        if (problem.turns_round && 2 * (k + 1) == problem.times.size()) balls.velocities *= -1;
    }
    trace.collisions_per_ball = 2 * static_cast<double>(trace.meetings.size()) / count;
    return trace;
}

/// All columns. The one that must not fail anywhere is named `champion`.
constexpr char const* champion = "fast double";

inline std::vector<Contender> contenders() {
    using reference::Textbook;
    std::vector<Contender> all;
    for (Precision const precision : {Precision::single_, Precision::double_})
        for (Method const method : {Method::table, Method::heap, Method::fast})
            all.push_back(clack_method(method, precision));
    all.push_back({"frames", Contender::Family::frames, absence_of_frames, step_frames});
    for (double const k : {1e3, 1e5, 1e7})
        all.push_back(
            {fmt::format("LAMMPS 10^{:.0f}", std::log10(k)), Contender::Family::lammps, {}, {}, k});
    all.push_back(textbook_rule(Textbook::naive_root, "naive root"));
    all.push_back(textbook_rule(Textbook::zero_is_never, "zero is never"));
    all.push_back(textbook_rule(Textbook::not_the_same, "not the same again"));
    all.push_back(textbook_rule(Textbook::absolute_time, "absolute time"));
    all.push_back(textbook_rule(Textbook::cell_from_floor, "cell by floor(x)"));
    return all;
}

/// How a contender fares with a problem. The variants may do anything, so they do it in a process
/// of their own.
inline Judged judged(Contender const& contender, Problem const& problem,
                     Reference const& reference) {
    Absence const absence = contender.absence(problem);
    if (absence != Absence::none) return Judged::absent(absence);
    auto const look_at_it = [&] {
        return judge(problem, reference, contender.fly(problem), contender.roundoff());
    };
    if (contender.family != Contender::Family::textbook) return look_at_it();
    ChildResult const result = run_in_child(
        [&]() -> Measurement {
            Judged const found = look_at_it();
            return {static_cast<double>(found.kind), found.digits};
        },
        problem.seconds_max());
    if (result.end == ChildEnd::out_of_time) return {Kind::hang, 0};
    if (result.end == ChildEnd::crashed) return {Kind::crash, 0};
    return {static_cast<Kind>(static_cast<int>(result.values[0])), result.values[1]};
}

} // namespace clack::validation::atlas
