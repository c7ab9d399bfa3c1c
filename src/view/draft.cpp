#include "view/draft.hpp"

#include <algorithm>

namespace clack::view {

namespace {

struct Far {
    float distance2; // from the eye
    Eigen::Index ball;
};

} // namespace

std::vector<Eigen::Index> balls_of_draft(Frame const& frame, Cut const& cut,
                                         Eigen::Vector3f const& eye, std::size_t most) {
    std::size_t const nearest = most / 2, farther = most - nearest;
    std::vector<Far> balls;
    balls.reserve(static_cast<std::size_t>(frame.system.count));
    for (Eigen::Index ball = 0; ball < frame.system.count; ++ball) {
        Eigen::Vector3f const place =
            (frame.snapshot.positions.col(ball) / frame.system.side).cast<float>();
        if (!cut.hides(place)) balls.push_back({(place - eye).squaredNorm(), ball});
    }
    std::size_t step = 1;
    if (balls.size() > most) {
        step = (balls.size() - nearest) / farther + 1;
        std::nth_element(
            balls.begin(), balls.begin() + static_cast<std::ptrdiff_t>(nearest), balls.end(),
            [](Far const& one, Far const& other) { return one.distance2 < other.distance2; });
    }
    std::vector<Eigen::Index> chosen;
    for (std::size_t rank = 0; rank < balls.size(); ++rank) {
        // By number and not by rank: or others would be seen at each turn.
        auto const ball = balls[rank].ball;
        if (rank < nearest || static_cast<std::size_t>(ball) % step == 0) chosen.push_back(ball);
    }
    return chosen;
}

} // namespace clack::view
