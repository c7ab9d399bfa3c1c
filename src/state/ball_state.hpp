#pragma once
// Where the balls are: all that a run consists of. Everything else is an index over it.

#include "state/ball.hpp"
#include "state/checkpoint.hpp"
#include "state/clock.hpp"
#include "state/huge_pages.hpp"
#include "state/limbs.hpp"
#include "state/memory_order.hpp"
#include "state/orderless_sum.hpp"
#include "state/snapshot.hpp"
#include "state/system.hpp"

#include <array>
#include <limits>
#include <numeric>
#include <vector>

namespace clack {

/// The records of n balls in their container, and the clock.
template <class Real, class Container> struct BallState {
    System system;
    Container cube;
    std::vector<Ball<Real>> balls;
    std::vector<std::int32_t> numbers;               // the permanent number of each record's ball
    std::vector<std::array<std::int32_t, 3>> images; // periodic: sides that wrapping took off
    Clock<Real> clock;
    Tallies tallies;

    static constexpr bool periodic = Container::boundary == Boundary::periodic;

    /// Time 0. Column i of the start is ball number i.
    BallState(System const& of, Start const& start, double epoch_length);
    /// The moment of a checkpoint of the same floating type.
    BallState(System const& of, Checkpoint const& checkpoint);

    std::int32_t count() const { return static_cast<std::int32_t>(balls.size()); }
    Ball<Real>& operator[](std::int32_t ball) { return balls[static_cast<std::size_t>(ball)]; }
    Ball<Real> const& operator[](std::int32_t ball) const {
        return balls[static_cast<std::size_t>(ball)];
    }

    /// Writes a record anew at a later time of the same flight.
    void fly_to(std::int32_t ball, Real time) {
        Ball<Real>& flight = (*this)[ball];
        Real const flown = time - flight.time;
        if constexpr (has_lanes<Real>) {
            auto place = point_and_time(flight) + velocity_four(flight) * flown;
            place[3] = time;
            set_point_and_time(flight, place);
        } else {
            for (int d = 0; d < 3; ++d) flight.point[d] += flight.velocity[d] * flown;
            flight.time = time;
        }
        if constexpr (periodic) {
            if (cube.holds(flight.point)) return;
            auto const laps = cube.wrap(flight.point);
            for (std::size_t d = 0; d < 3; ++d)
                images[static_cast<std::size_t>(ball)][d] += laps[d];
        }
    }

    /// Writes every record at one moment, which becomes the clock's zero.
    void set_records_to(Real offset) {
        for (std::int32_t ball = 0; ball < count(); ++ball) {
            fly_to(ball, offset);
            (*this)[ball].time = 0;
        }
        clock.offset = 0;
    }

    /// Brings balls that are near in space near in memory; their numbers stay.
    void put_in_memory_order() {
        auto const order = memory_order(balls, cube.origin(), cube.extent());
        if (order.empty()) return;
        reorder(balls, order);
        reorder(numbers, order);
        if constexpr (periodic) reorder(images, order);
    }

    /// Index of the record of each ball number.
    std::vector<std::int32_t> by_number() const {
        std::vector<std::int32_t> index(balls.size());
        for (std::int32_t i = 0; i < count(); ++i)
            index[static_cast<std::size_t>(numbers[static_cast<std::size_t>(i)])] = i;
        return index;
    }

    Snapshot snapshot() const;
    Checkpoint checkpoint() const;
    Real kinetic_energy() const;
    Vector3<Real> momentum() const;

    std::size_t bytes() const {
        return balls.capacity() * sizeof(Ball<Real>) + numbers.capacity() * sizeof(std::int32_t) +
               images.capacity() * sizeof(images[0]);
    }
};

template <class Real, class Container>
BallState<Real, Container>::BallState(System const& of, Start const& start, double epoch_length)
    : system(of), cube(of), balls(large_vector<Ball<Real>>(static_cast<std::size_t>(of.count))),
      numbers(large_vector<std::int32_t>(balls.size())),
      images(large_vector<std::array<std::int32_t, 3>>(periodic ? balls.size() : 0)),
      clock{epoch_length, 0, 0} {
    std::iota(numbers.begin(), numbers.end(), 0);
    for (std::int32_t i = 0; i < count(); ++i) {
        Ball<Real>& ball = (*this)[i];
        ball.point = start.positions.col(i).cast<Real>();
        ball.velocity = start.velocities.col(i).cast<Real>();
        ball.time = 0;
        // A place that the floating type rounds across the boundary belongs on it.
        if constexpr (periodic) {
            cube.wrap(ball.point);
        } else {
            ball.point = ball.point.cwiseMax(cube.low).cwiseMin(cube.high);
        }
    }
}

template <class Real, class Container>
BallState<Real, Container>::BallState(System const& of, Checkpoint const& checkpoint)
    : system(of), cube(of), balls(large_vector<Ball<Real>>(static_cast<std::size_t>(of.count))),
      numbers(large_vector<std::int32_t>(balls.size())),
      images(large_vector<std::array<std::int32_t, 3>>(periodic ? balls.size() : 0)),
      tallies(checkpoint.tallies) {
    std::iota(numbers.begin(), numbers.end(), 0);
    std::size_t position = 0;
    clock = {checkpoint.epoch_length, checkpoint.epoch,
             take_limbs<Real>(checkpoint.offset, position)};
    position = 0;
    for (std::int32_t i = 0; i < count(); ++i) {
        Ball<Real>& ball = (*this)[i];
        for (int d = 0; d < 3; ++d) ball.point[d] = take_limbs<Real>(checkpoint.records, position);
        for (int d = 0; d < 3; ++d)
            ball.velocity[d] = take_limbs<Real>(checkpoint.records, position);
        ball.time = take_limbs<Real>(checkpoint.records, position);
        if constexpr (periodic) {
            for (int d = 0; d < 3; ++d) {
                images[static_cast<std::size_t>(i)][static_cast<std::size_t>(d)] =
                    checkpoint.images(d, i);
            }
        }
    }
}

template <class Real, class Container> Snapshot BallState<Real, Container>::snapshot() const {
    Snapshot shot;
    shot.time = clock.time();
    shot.ball_collisions = tallies.ball_collisions;
    shot.positions.resize(3, count());
    shot.velocities.resize(3, count());
    shot.images = Eigen::Matrix3Xi::Zero(3, count());
    for (std::int32_t i = 0; i < count(); ++i) {
        auto const number = numbers[static_cast<std::size_t>(i)];
        Vector3<Real> place = (*this)[i].position(clock.offset);
        if constexpr (periodic) {
            auto const laps = cube.wrap(place);
            for (std::size_t d = 0; d < 3; ++d) {
                shot.images(static_cast<Eigen::Index>(d), number) =
                    images[static_cast<std::size_t>(i)][d] + laps[d];
            }
        }
        shot.positions.col(number) = place.template cast<double>();
        shot.velocities.col(number) = (*this)[i].velocity.template cast<double>();
    }
    return shot;
}

template <class Real, class Container> Checkpoint BallState<Real, Container>::checkpoint() const {
    Checkpoint kept;
    kept.limbs = limb_count<Real>;
    kept.epoch_length = clock.length;
    kept.epoch = clock.epoch;
    kept.offset.resize(static_cast<std::size_t>(kept.limbs));
    write_limbs(clock.offset, kept.offset.data());
    auto const numbers_a_ball = 7 * static_cast<std::size_t>(kept.limbs);
    kept.records.resize(balls.size() * numbers_a_ball);
    kept.images = Eigen::Matrix3Xi::Zero(3, count());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        std::int32_t const number = numbers[i];
        double* at = kept.records.data() + static_cast<std::size_t>(number) * numbers_a_ball;
        for (int d = 0; d < 3; ++d) at = write_limbs(balls[i].point[d], at);
        for (int d = 0; d < 3; ++d) at = write_limbs(balls[i].velocity[d], at);
        write_limbs(balls[i].time, at);
        if constexpr (periodic) {
            for (int d = 0; d < 3; ++d)
                kept.images(d, number) = images[i][static_cast<std::size_t>(d)];
        }
    }
    kept.tallies = tallies;
    return kept;
}

/// The sum has the same bits in any memory order, and a million balls add no drift of their own.
template <class Real, class Container> Real BallState<Real, Container>::kinetic_energy() const {
    Real sum = 0;
    if constexpr (std::numeric_limits<Real>::digits <= std::numeric_limits<double>::digits) {
        OrderlessSum exact;
        for (auto const& ball : balls)
            exact.add(static_cast<double>(dot<Real>(ball.velocity, ball.velocity)));
        sum = static_cast<Real>(exact.value());
    } else {
        Real lost = 0; // Kahan's correction
        for (std::int32_t const i : by_number()) {
            Real const term = dot<Real>((*this)[i].velocity, (*this)[i].velocity) - lost;
            Real const next = sum + term;
            lost = (next - sum) - term;
            sum = next;
        }
    }
    return sum * static_cast<Real>(system.mass) / 2;
}

template <class Real, class Container> Vector3<Real> BallState<Real, Container>::momentum() const {
    Vector3<Real> sum = Vector3<Real>::Zero();
    for (std::int32_t const i : by_number()) sum += (*this)[i].velocity;
    return sum * static_cast<Real>(system.mass);
}

} // namespace clack
