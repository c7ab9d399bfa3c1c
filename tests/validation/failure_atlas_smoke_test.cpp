// The failure atlas: its checks see each way to fail, the engine fails in none, each rule of the
// textbooks in one.

#include "validation/atlas_methods.hpp"
#include "validation/atlas_scenes.hpp"

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
    Trace trace = *contender(champion).fly(problem);

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
        Trace const trace = *contender(method).fly(problem);
        BOOST_TEST_REQUIRE(trace.meetings.size() == 2);
        BOOST_TEST((trace.meetings[0] == atlas::Meeting{0, 1}));
        BOOST_TEST((trace.meetings[1] == atlas::Meeting{0, 2}));
    }
}

BOOST_AUTO_TEST_CASE(fast_method_fails_in_no_scene) {
    for (Scene const& row : scenes(Profile::quick)) {
        bool const long_one = row.name == "long run" || row.name == "balls on a line";
        double const k = long_one ? row.levels.front() : row.levels[row.levels.size() - 2];
        BOOST_TEST_CONTEXT(row.name)
        BOOST_TEST(judged_in(champion, row.name, k).kind == Kind::ok);
    }
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
