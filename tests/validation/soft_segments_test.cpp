#include "validation/soft_segments.hpp"

#include <boost/test/unit_test.hpp>

using namespace clack;
using namespace clack::validation;

namespace {

Meeting pair_at(double time, std::int64_t first, std::int64_t second) {
    return {CollisionKind::ball, time, first, second};
}
Meeting wall_at(double time, std::int64_t ball, std::int64_t wall) {
    return {CollisionKind::wall, time, ball, wall};
}

/// A segment of six balls that lasts 1.
Segment segment_of(std::vector<Meeting> meetings) {
    Segment segment;
    segment.start.positions.resize(3, 6);
    segment.time = 1;
    segment.meetings = std::move(meetings);
    return segment;
}

std::string kept_of(std::vector<Meeting> meetings, double span = 0.1) {
    std::string text;
    for (bool const kept : masked(segment_of(std::move(meetings)), span).kept)
        text += kept ? '1' : '0';
    return text;
}

} // namespace

BOOST_AUTO_TEST_CASE(only_balls_that_meet_are_kept) {
    BOOST_TEST(kept_of({pair_at(0.5, 0, 1), wall_at(0.5, 3, 0)}) == "110100");
}

BOOST_AUTO_TEST_CASE(collisions_near_the_end_are_dropped) {
    BOOST_TEST(kept_of({pair_at(0.95, 0, 1), wall_at(0.91, 2, 0), wall_at(0.89, 3, 0)}) ==
               "000100");
}

BOOST_AUTO_TEST_CASE(collisions_that_follow_at_once_are_dropped_with_both_partners) {
    BOOST_TEST(kept_of({pair_at(0.5, 0, 1), pair_at(0.55, 1, 2), wall_at(0.2, 3, 0)}) == "000100");
    BOOST_TEST(kept_of({pair_at(0.5, 0, 1), wall_at(0.55, 1, 2)}) == "000000");
    BOOST_TEST(kept_of({pair_at(0.5, 0, 1), pair_at(0.65, 1, 2)}) == "111000");
}

BOOST_AUTO_TEST_CASE(two_walls_at_once_do_not_matter) {
    BOOST_TEST(kept_of({wall_at(0.5, 0, 0), wall_at(0.51, 0, 2)}) == "100000");
    // nor does a wall hide the collision before it
    BOOST_TEST(kept_of({pair_at(0.47, 0, 1), wall_at(0.5, 0, 0), wall_at(0.56, 0, 2)}) == "000000");
}

BOOST_AUTO_TEST_CASE(what_a_dropped_ball_touches_later_is_dropped) {
    BOOST_TEST(kept_of({pair_at(0.1, 4, 5), pair_at(0.2, 1, 3), pair_at(0.5, 0, 1),
                        pair_at(0.55, 1, 2), pair_at(0.8, 2, 4)}) == "000101");
}

BOOST_AUTO_TEST_CASE(kept_fraction_is_of_the_balls_that_meet) {
    Mask const mask = masked(segment_of({pair_at(0.5, 0, 1), wall_at(0.95, 2, 0)}), 0.1);
    BOOST_TEST(mask.met == 3);
    BOOST_TEST(std::abs(mask.kept_fraction() - 2.0 / 3) < 1e-15);
}

BOOST_AUTO_TEST_CASE(richardson_removes_an_error_of_first_order) {
    Eigen::Matrix3Xd limit = Eigen::Matrix3Xd::Random(3, 4), slope = Eigen::Matrix3Xd::Random(3, 4);
    auto const at = [&](double k) -> Eigen::Matrix3Xd { return limit + slope / std::sqrt(k); };
    Eigen::Matrix3Xd const left = richardson(at(100), at(400)) - limit;
    BOOST_TEST(left.cwiseAbs().maxCoeff() < 1e-15);
    BOOST_TEST((at(400) - limit).cwiseAbs().maxCoeff() > 1e-3);
}

BOOST_AUTO_TEST_CASE(distances_are_of_kept_balls) {
    Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Zero(3, 2), b = a;
    b.col(1) = Eigen::Vector3d(2, 3, 6);
    BOOST_TEST((distances(a, b, {false, true}) == std::vector<double>{7}));
}

BOOST_AUTO_TEST_CASE(quantiles_are_values_of_the_sample) {
    std::vector<double> hundred;
    for (int k = 100; k > 0; --k) hundred.push_back(k);
    BOOST_TEST(quantile(hundred, 0.5) == 50);
    BOOST_TEST(quantile(hundred, 0.99) == 99);
    BOOST_TEST(quantile({3}, 0.99) == 3);
    BOOST_TEST(std::isnan(quantile({}, 0.5)));
}
