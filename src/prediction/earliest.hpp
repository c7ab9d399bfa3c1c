#pragma once
// The earliest contact of one ball with any of its candidates.

#include "prediction/contact.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace clack {

constexpr std::int32_t no_ball = -7; // the numbers from -1 to -6 are the walls' (scheduling)

/// The contact that a search over candidates found; `ball` is no_ball when there is none, and
/// `time` then infinite or beyond the limit of the search.
template <class Real> struct Contact {
    Real time = infinity<Real>;
    std::int32_t ball = no_ball;
};

/// What a prediction reads: the records, their permanent numbers, the cube and the balls' model.
template <class Real, class Container, class Model> struct Scenery {
    std::vector<Ball<Real>> const& balls;
    std::vector<std::int32_t> const& numbers;
    Container const& cube;
    Model const& model;
    bool several_images; // the box is so small that a pair can touch through more than one image
};

/// Whether the notes say when balls mean to touch something; some models keep their own there.
template <class Model> constexpr bool heeds_notes = !requires { Model::keeps_notes; };

/// For a separation that is not taken through any image.
struct Unbounded {
    static constexpr Boundary boundary = Boundary::walls;
};

/// The earliest contact of two balls through the nearest image and the 26 around it. Each
/// separation is rounded once, so that it is the same whichever image is nearest.
template <class Real, class Container, class Model>
[[gnu::noinline]] Real contact_time_of_images(Scenery<Real, Container, Model> const& scenery,
                                              Ball<Real> const& i, Ball<Real> const& j, Real now) {
    Container const& cube = scenery.cube;
    Pair<Real> const direct = pair_of(i, j, Unbounded{}, now);
    auto const through = [&](Real r, Real v, int image) {
        Real const nearest = cube.image(r + v * (now - direct.time));
        return r - (nearest + static_cast<Real>(image)) * cube.side;
    };
    Real best = std::numeric_limits<Real>::quiet_NaN();
    for (int image = 0; image < 27; ++image) {
        Pair<Real> pair = direct;
        pair.x = through(direct.x, direct.vx, image % 3 - 1);
        pair.y = through(direct.y, direct.vy, image / 3 % 3 - 1);
        pair.z = through(direct.z, direct.vz, image / 9 - 1);
        Real const time = scenery.model.contact_time(pair);
        if (!(best <= time) && time == time) best = time;
    }
    return best;
}

/// Time of the contact of balls i and j through any image; NaN when they never touch.
template <class Real, class Container, class Model>
[[gnu::always_inline]] inline Real contact_time(Scenery<Real, Container, Model> const& scenery,
                                                std::int32_t i, std::int32_t j, Real now) {
    auto const& balls = scenery.balls;
    auto const index = [](std::int32_t ball) { return static_cast<std::size_t>(ball); };
    if constexpr (Container::boundary == Boundary::periodic)
        if (scenery.several_images)
            return contact_time_of_images(scenery, balls[index(i)], balls[index(j)], now);
    return scenery.model.contact_time(pair_of(balls[index(i)], balls[index(j)], scenery.cube, now));
}

/// Whether a contact with ball j comes before the best so far: equal times go to the lower number.
template <class Real, class Container, class Model>
bool comes_first(Scenery<Real, Container, Model> const& scenery, Real time, std::int32_t j,
                 Contact<Real> const& best) {
    if (time != best.time) return time < best.time;
    auto const number = [&](std::int32_t ball) {
        return scenery.numbers[static_cast<std::size_t>(ball)];
    };
    return best.ball != no_ball && number(j) < number(best.ball);
}

/// One candidate after the other: what many at a time must agree with to the last bit, and what
/// the types without a vector unit use.
template <class Real, class Container, class Model>
[[gnu::noinline]] Contact<Real>
earliest_one_by_one(Scenery<Real, Container, Model> const& scenery, std::int32_t i,
                    std::span<std::int32_t const> candidates, Real now) {
    Contact<Real> best;
    for (std::int32_t const j : candidates) {
        if (j == i) continue;
        Real const time = contact_time(scenery, i, j, now);
        if (heeds_notes<Model> && scenery.balls[static_cast<std::size_t>(j)].note < time) continue;
        if (comes_first(scenery, time, j, best)) best = {time, j};
    }
    return best;
}

/// How the records of a ball and its candidates lie in time.
enum class Flight {
    begins_now, // the ball was written at `now`: every pair's time is `now`
    goes_on     // it flies since earlier: each pair has its own time
};

/// The pairs of one ball with as many others as there are lanes.
template <Flight flight, class Real, class Container>
[[gnu::always_inline]] inline Pair<Lanes<Real>>
pairs_of(Ball<Real> const& ball, BallLanes<Real> const& other, Container const& cube, Real now) {
    using V = Lanes<Real>;
    V time = broadcast(ball.time);
    V x = broadcast(ball.point[0]), y = broadcast(ball.point[1]), z = broadcast(ball.point[2]);
    if constexpr (flight == Flight::goes_on) {
        time = later(time, other.time);
        V const flown = time - ball.time;
        x = x + ball.velocity[0] * flown;
        y = y + ball.velocity[1] * flown;
        z = z + ball.velocity[2] * flown;
    }
    V const flown = time - other.time;
    Pair<V> pair{(other.x + other.vx * flown) - x,
                 (other.y + other.vy * flown) - y,
                 (other.z + other.vz * flown) - z,
                 other.vx - ball.velocity[0],
                 other.vy - ball.velocity[1],
                 other.vz - ball.velocity[2],
                 time};
    if constexpr (Container::boundary == Boundary::periodic) {
        auto const nearest = [&](V distance, V velocity) {
            if constexpr (flight == Flight::begins_now) {
                return distance - cube.image(distance) * cube.side;
            } else {
                return distance - cube.image(distance + velocity * (now - time)) * cube.side;
            }
        };
        pair.x = nearest(pair.x, pair.vx);
        pair.y = nearest(pair.y, pair.vy);
        pair.z = nearest(pair.z, pair.vz);
    }
    return pair;
}

/// As many candidates of one ball at a time as there are lanes, `most` in all. The candidates, one
/// at least, are padded to a multiple of that with the ball itself, which never touches itself,
/// having no velocity relative to itself (unless balls grow). All times are kept and the earliest
/// is found among them in one mask: 1.02 to 1.04 times as fast as to keep track of it lane by lane.
/// Tried at crossings and left: no roots where no lane touches, 0.96 to 1.01.
template <Flight flight, class Real, class Container, class Model> class LaneSearch {
public:
    static constexpr std::size_t most = 64; // a bit each

    [[gnu::always_inline]] LaneSearch(Scenery<Real, Container, Model> const& scenery,
                                      std::int32_t ball, std::span<std::int32_t const> candidates,
                                      Real now)
        : scenery_(scenery), record_(scenery.balls[static_cast<std::size_t>(ball)]), ball_(ball),
          candidates_(candidates), now_(now) {}

    std::size_t size() const { return candidates_.size(); }

    /// The candidates from number `first` on.
    [[gnu::always_inline]] void look_at(std::size_t first) {
        BallLanes<Real> const other = load_balls(scenery_.balls.data(), candidates_.data() + first);
        V time = scenery_.model.contact_time(pairs_of<flight>(record_, other, scenery_.cube, now_));
        V const never = broadcast(infinity<Real>);
        if constexpr (heeds_notes<Model>) {
            time = time <= other.note ? time : never;
        } else {
            time = time < never ? time : never;
        }
        if constexpr (Model::grows) {
            for (int lane = 0; lane < lane_count; ++lane) {
                if (candidates_[first + static_cast<std::size_t>(lane)] == ball_)
                    time[lane] = never[lane];
            }
        }
        times_[first / lane_count] = time;
        best_ = time < best_ ? time : best_;
    }

    /// Contacts that are not before `limit` are left out.
    [[gnu::always_inline]] Contact<Real> earliest(Real limit) const {
        Real const time = folded(best_, [](V const& a, V const& b) { return a < b ? a : b; });
        V const earliest = broadcast(time);
        std::uint64_t here = 0;
        for (std::size_t first = 0; first < size(); first += lane_count)
            here |= std::uint64_t{bits_of_equal(times_[first / lane_count], earliest)} << first;
        // Sums, not branches: whether there is a contact cannot be foretold.
        bool const found = time < limit;
        here = (here & (0 - std::uint64_t{found})) | std::uint64_t{!found};
        // Ties are for lattices: then the numbers decide, one by one.
        if ((here & (here - 1)) != 0)
            return earliest_one_by_one(scenery_, ball_, candidates_, now_);
        std::int32_t const other = candidates_[static_cast<std::size_t>(__builtin_ctzll(here))];
        std::int32_t const all = -std::int32_t{found};
        return {time, (other & all) | (no_ball & ~all)};
    }

private:
    using V = Lanes<Real>;

    Scenery<Real, Container, Model> const& scenery_;
    Ball<Real> const& record_;
    std::int32_t ball_;
    std::span<std::int32_t const> candidates_;
    Real now_;
    V best_ = broadcast(infinity<Real>);
    V times_[most / lane_count];
};

template <Flight flight, class Real, class Container, class Model>
[[gnu::always_inline]] inline Contact<Real>
earliest_of_some(Scenery<Real, Container, Model> const& scenery, std::int32_t i,
                 std::span<std::int32_t const> candidates, Real now, Real limit) {
    LaneSearch<flight, Real, Container, Model> search(scenery, i, candidates, now);
    for (std::size_t first = 0; first < search.size(); first += lane_count) search.look_at(first);
    return search.earliest(limit);
}

/// The same of none, or of more than one mask can name. What is rare stands in a function of its
/// own: without it in the way, cells are 1.03 times as fast at packing fraction 0.05.
template <Flight flight, class Real, class Container, class Model>
[[gnu::noinline]] Contact<Real>
earliest_of_many(Scenery<Real, Container, Model> const& scenery, std::int32_t i,
                 std::span<std::int32_t const> candidates, Real now, Real limit) {
    constexpr std::size_t most = LaneSearch<flight, Real, Container, Model>::most;
    Contact<Real> best;
    for (std::size_t from = 0; from < candidates.size(); from += most) {
        auto const some = candidates.subspan(from, std::min(most, candidates.size() - from));
        Contact<Real> const found = earliest_of_some<flight>(scenery, i, some, now, limit);
        if (found.ball != no_ball && comes_first(scenery, found.time, found.ball, best))
            best = found;
    }
    return best;
}

template <Flight flight, class Real, class Container, class Model>
[[gnu::noinline]] Contact<Real>
earliest_in_lanes(Scenery<Real, Container, Model> const& scenery, std::int32_t i,
                  std::span<std::int32_t const> candidates, Real now, Real limit) {
    // One comparison for both that are rare: none at all wraps around to very many.
    if (candidates.size() - 1 >= LaneSearch<flight, Real, Container, Model>::most)
        return earliest_of_many<flight>(scenery, i, candidates, now, limit);
    return earliest_of_some<flight>(scenery, i, candidates, now, limit);
}

/// The earliest contact of ball i with the candidates (padded as above), at or after the later of
/// each pair's records. Candidates that mean to touch something else before are left out: they will
/// be predicted themselves by then, and find ball i if they still meet it.
/// Measured at packing fractions 0.05, 0.20 and 0.49: of 0.22, 0.30 and 0.48 events a collision
/// that had come to nothing 0.10, 0.14 and 0.21 are left; 1.04, 1.04 and 1.00 times as fast.
///   now    the present offset: it picks the images and nothing else
///   limit  contacts that are later may be left out
template <class Real, class Container, class Model>
Contact<Real> earliest_contact(Scenery<Real, Container, Model> const& scenery, std::int32_t i,
                               std::span<std::int32_t const> candidates, Real now,
                               [[maybe_unused]] Real limit = infinity<Real>) {
    if constexpr (has_lanes<Real>) {
        if (!scenery.several_images) {
            // A hair later, so that a contact at the limit itself is no tie with it.
            limit += std::numeric_limits<Real>::epsilon() * limit;
            // The newest record spares a quarter of the arithmetic and gives the same bits.
            if (scenery.balls[static_cast<std::size_t>(i)].time == now)
                return earliest_in_lanes<Flight::begins_now>(scenery, i, candidates, now, limit);
            return earliest_in_lanes<Flight::goes_on>(scenery, i, candidates, now, limit);
        }
    }
    return earliest_one_by_one(scenery, i, candidates, now);
}

/// The same for two balls that have both been written at `now`, side by side: neither waits for the
/// other's roots. Measured at packing fractions 0.05, 0.20, 0.40 and 0.49: 1.05, 1.08, 1.04
/// and 1.03 times as fast.
template <class Real, class Container, class Model>
std::pair<Contact<Real>, Contact<Real>>
earliest_contacts(Scenery<Real, Container, Model> const& scenery, std::int32_t i,
                  std::span<std::int32_t const> candidates_i, std::int32_t j,
                  std::span<std::int32_t const> candidates_j, Real now) {
    if constexpr (has_lanes<Real>) {
        using Search = LaneSearch<Flight::begins_now, Real, Container, Model>;
        if (!scenery.several_images &&
            std::max(candidates_i.size(), candidates_j.size()) <= Search::most) {
            Search one(scenery, i, candidates_i, now), other(scenery, j, candidates_j, now);
            std::size_t const both = std::min(one.size(), other.size());
            std::size_t first = 0;
            for (; first < both; first += lane_count) {
                one.look_at(first);
                other.look_at(first);
            }
            for (std::size_t k = first; k < one.size(); k += lane_count) one.look_at(k);
            for (std::size_t k = first; k < other.size(); k += lane_count) other.look_at(k);
            return {one.earliest(infinity<Real>), other.earliest(infinity<Real>)};
        }
    }
    return {earliest_contact(scenery, i, candidates_i, now),
            earliest_contact(scenery, j, candidates_j, now)};
}

} // namespace clack
