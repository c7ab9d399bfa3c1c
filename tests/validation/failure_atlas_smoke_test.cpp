// The failure atlas: its checks see each way to fail, the engine fails in none, each rule of the
// textbooks in one.

#include "tests/reference/needs_lammps.hpp"
#include "validation/atlas_rows.hpp"

#include <boost/test/unit_test.hpp>

#include <cstdlib>

using namespace clack;
using namespace clack::validation;
using namespace clack::validation::atlas;

namespace clack::validation::atlas { // for what Boost.Test prints
static std::ostream& operator<<(std::ostream& out, Kind kind) {
    return out << static_cast<int>(kind);
}
} // namespace clack::validation::atlas

namespace {

Contender contender(std::string const& name) {
    for (Contender const& one : contenders())
        if (one.name == name) return one;
    throw std::out_of_range(name);
}

Scene scene(std::string const& name) {
    for (Scene const& one : scenes(Profile::quick))
        if (one.name == name) return one;
    throw std::out_of_range(name);
}

Judged judged_in(std::string const& method, std::string const& row, double k) {
    Problem const problem = scene(row).make(k);
    return judged(contender(method), problem, reference_of(problem));
}

/// Two balls that meet once, with the answer, to be spoilt.
struct OneMeeting {
    Problem problem = scene("near contact").make(1);
    Reference reference = reference_of(problem);
    Trace trace = contender(champion).fly(problem);

    Kind kind() const { return judge(problem, reference, trace, double_roundoff).kind; }
};

} // namespace

BOOST_AUTO_TEST_CASE(each_way_to_fail_is_told_from_the_others) {
    BOOST_TEST(OneMeeting().kind() == Kind::ok);
    OneMeeting less;
    less.trace.frames.back().places(0, 0) += 1e-10;
    BOOST_TEST(less.kind() == Kind::digits);
    Judged const judgement = judge(less.problem, less.reference, less.trace, double_roundoff);
    BOOST_TEST(judgement.digits > 2);
    BOOST_TEST(judgement.digits < 5);
    OneMeeting unmet;
    unmet.trace.meetings.clear();
    BOOST_TEST(unmet.kind() == Kind::order);
    OneMeeting deep;
    deep.trace.frames.back().places.col(0) =
        deep.trace.frames.back().places.col(1) + Eigen::Vector3d(0.99, 0, 0);
    BOOST_TEST(deep.kind() == Kind::overlap);
    OneMeeting hot;
    hot.trace.frames.back().velocities *= 1.01;
    BOOST_TEST(hot.kind() == Kind::energy);
    for (double const place : {-0.1, 8.1, std::numeric_limits<double>::quiet_NaN()}) {
        OneMeeting lost;
        lost.trace.frames.back().places(1, 1) = place;
        BOOST_TEST(lost.kind() == Kind::lost);
    }
    OneMeeting stuck;
    stuck.trace.end = End::hang;
    BOOST_TEST(stuck.kind() == Kind::hang);
}

BOOST_AUTO_TEST_CASE(energy_is_held_to_rounding_where_nothing_else_is_known) {
    OneMeeting meeting;
    meeting.reference = {};
    BOOST_TEST(meeting.kind() == Kind::ok);
    meeting.trace.frames.back().velocities *= 1 + 1e-13;
    BOOST_TEST(meeting.kind() == Kind::energy);
}

BOOST_AUTO_TEST_CASE(physics_has_no_answer_for_symmetric_triples_alone) {
    BOOST_TEST(!reference_of(scene("symmetric triple").make(17)).has_limit);
    BOOST_TEST(reference_of(scene("symmetric triple").make(13)).has_limit);
    BOOST_TEST(reference_of(scene("touching cradle").make(1)).has_limit);
    BOOST_TEST(reference_of(scene("corner").make(17)).has_limit);
}

BOOST_AUTO_TEST_CASE(tie_rule_lets_the_lower_numbers_meet_first) {
    Problem const problem = scene("symmetric triple").make(17);
    for (char const* const method : {"table double", "heap double", "fast double", "fast float"}) {
        Trace const trace = contender(method).fly(problem);
        BOOST_TEST_REQUIRE(trace.meetings.size() == 2);
        BOOST_TEST((trace.meetings[0] == atlas::Meeting{0, 1}));
        BOOST_TEST((trace.meetings[1] == atlas::Meeting{0, 2}));
    }
}

BOOST_AUTO_TEST_CASE(fast_method_fails_in_no_scene) {
    for (Scene const& row : scenes(Profile::quick)) {
        bool const long_one = row.name == "balls on a line";
        double const k = row.name.ends_with("long run") ? 3
                         : long_one                     ? row.levels.front()
                                                        : row.levels[row.levels.size() - 2];
        BOOST_TEST_CONTEXT(row.name)
        BOOST_TEST(judged_in(champion, row.name, k).kind == Kind::ok);
    }
}

// Other seeds are other starts wherever chance has a part in them.
BOOST_AUTO_TEST_CASE(rows_of_another_draw_start_otherwise) {
    auto const one = scenes(Profile::quick), other = scenes(Profile::quick, 1);
    std::vector<std::string> drawn;
    for (std::size_t r = 0; r < one.size(); ++r) {
        double const k = one[r].levels.front();
        Start const a = one[r].make(k).start, b = other[r].make(k).start;
        if (a.positions != b.positions || a.velocities != b.velocities)
            drawn.push_back(one[r].name);
    }
    std::vector<std::string> const by_chance{"lattice of equal speeds",
                                             "one fast ball",
                                             "near close packing",
                                             "long run",
                                             "very long run",
                                             "late clock",
                                             "time reversal",
                                             "balls on a line",
                                             "far from zero"};
    BOOST_TEST(drawn == by_chance, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(long_runs_are_as_long_as_they_say) {
    Problem const problem = scene("long run").make(4);
    Judged const found = judged(contender(champion), problem, reference_of(problem));
    BOOST_TEST(found.extent.collisions == 1e4);
    BOOST_TEST(found.extent.deepest_overlap > 0);
    BOOST_TEST(found.extent.deepest_overlap < 1e-13);
    BOOST_TEST(found.extent.energy_drift < 1e-12);
}

BOOST_AUTO_TEST_CASE(places_that_stay_empty_say_why) {
    auto const absence = [](std::string const& method, std::string const& row, double k) {
        Problem const problem = scene(row).make(k);
        return judged(contender(method), problem, reference_of(problem)).absence;
    };
    BOOST_TEST((absence("table double", "very long run", 3) == Absence::too_long));
    BOOST_TEST((absence("frames", "long run", 6) == Absence::too_long));
    BOOST_TEST((absence("frames", "two periodic balls", 4) == Absence::none));
    auto const soft = [](std::string const& row, double k) {
        return SoftProblem{scene(row).make(k), 1e3}.absence();
    };
    BOOST_TEST((soft("tiny balls", 4) == Absence::too_wide));
    BOOST_TEST((soft("dilute", 4) == Absence::none)); // wider still, but periodic
    BOOST_TEST((soft("time reversal", 4) == Absence::turns_round));
    BOOST_TEST((soft("near contact", 4) == Absence::none));
}

/// Softness costs digits, and nothing else where contacts are short beside the time between them.
BOOST_AUTO_TEST_CASE(soft_balls_follow_hard_ones_through_periodic_faces, *NeedsLammps()) {
    Problem const problem = scene("two periodic balls").make(4);
    SoftBalls soft;
    auto const traces = soft.fly({{problem, 1e3}, {problem, 1e5}});
    Reference const reference = reference_of(problem);
    BOOST_TEST_REQUIRE(!reference.meetings.empty());
    double error_before = infinity<double>;
    for (auto const& trace : traces) {
        BOOST_TEST_REQUIRE(trace.has_value());
        BOOST_TEST_REQUIRE(trace->frames.size() == problem.times.size());
        BOOST_TEST((judge(problem, reference, *trace, double_roundoff).kind == Kind::digits));
        double const error =
            largest_distance(problem, trace->frames.back().places, reference.frames.back().places);
        BOOST_TEST(error < error_before / 3); // as the root of the stiffness
        error_before = error;
    }
}

/// A method that loses digits from k = 3.3 on and balls from 9.6 on.
BOOST_AUTO_TEST_CASE(thresholds_are_found_by_bisection) {
    Contender const spoilt{
        "spoilt", Contender::Family::frames, [](Problem const&) { return Absence::none; },
        [](Problem const& problem) {
            Trace trace = contender(champion).fly(problem);
            double const k =
                -std::log10(problem.start.positions.col(1)[0] - problem.start.positions.col(0)[0]);
            trace.frames.back().places(0, 0) += k > 9.6 ? 100 : k > 3.3 ? 1e-9 : 0;
            return trace;
        }};
    Scene const apart{"apart", "10^-k", levels(1, 13, 2), [](double k) {
                          return between_walls(8, {{2, 2, 2}, {2 + tenth(k), 6, 2}},
                                               {{0.25, 0, 0}, {0.25, 0, 0}}, 1);
                      }};
    SoftBalls soft;
    Cell const cell = RowMeasurement(apart, {spoilt}).measure(soft).cells.front();
    BOOST_TEST((cell.worst == Kind::lost));
    BOOST_TEST(cell.threshold == 3.3, boost::test_tools::tolerance(0.25 / 3.3));
    BOOST_TEST(cell.gross == 9.6, boost::test_tools::tolerance(0.25 / 9.6));
    BOOST_TEST(cell.reached == 13);
    Row row;
    row.cells = {cell};
    Cell const kept = unflat(flat(row), 1).cells.front();
    BOOST_TEST(kept.gross == cell.gross);
    BOOST_TEST(kept.extent.collisions == cell.extent.collisions);
}

BOOST_AUTO_TEST_CASE(each_rule_of_the_textbooks_fails_in_a_scene) {
    BOOST_TEST(judged_in("naive root", "tiny balls", 5).kind >= Kind::digits);
    BOOST_TEST(judged_in("zero is never", "touching", 0).kind == Kind::overlap);
    BOOST_TEST(judged_in("not the same again", "two periodic balls", 4).kind == Kind::overlap);
    Judged const late = judged_in("absolute time", "late clock", 12);
    BOOST_TEST(late.kind == Kind::digits);
    BOOST_TEST(late.digits > 7);
    BOOST_TEST(judged_in("cell by floor(x)", "all at rest but one", 2).kind == Kind::hang);
}

BOOST_AUTO_TEST_CASE(children_bring_numbers_back_crash_or_run_out_of_time) {
    ChildResult const good = run_in_child([]() -> Measurement { return {1, 2.5}; }, 5);
    BOOST_TEST((good.end == ChildEnd::finished));
    BOOST_TEST(good.values == (Measurement{1, 2.5}));
    auto const crash = []() -> Measurement { std::abort(); };
    BOOST_TEST((run_in_child(crash, 5).end == ChildEnd::crashed));
    auto const fail = []() -> Measurement { throw std::runtime_error("no"); };
    BOOST_TEST((run_in_child(fail, 5).end == ChildEnd::crashed));
    auto const hang = []() -> Measurement {
        bool volatile done = false;
        while (!done) {
        }
        return {};
    };
    BOOST_TEST((run_in_child(hang, 1).end == ChildEnd::out_of_time));
}
