#include "scenes/insertion.hpp"

#include "scenes/draw.hpp"
#include "scenes/near_places.hpp"
#include "scenes/packing.hpp"
#include "simulation/growth.hpp"
#include "state/errors.hpp"

#include <algorithm>
#include <optional>

namespace clack {

namespace {

/// Insertion ends near 0.38, where no hole is left; up to here it takes a few draws a ball.
constexpr double insertion_limit = 0.25;

/// So many balls are simply tried: the room at the walls, most of a small cube's, is not counted by
/// any packing fraction.
constexpr std::int64_t a_few = 32;

/// Starts for these when they jam as they grow: one can get stuck where another does not.
constexpr int attempts_of_a_few = 5;

/// Draws for one ball before the start is given up for smaller balls.
constexpr int most_draws = 2000;

/// Balls are inserted block by block, so that what is looked at stays in the cache. Each block gets
/// its even share, which also keeps the density even over long distances.
constexpr double balls_per_block = 256;

/// A part of the room that the centres have.
struct Block {
    Eigen::Vector3d corner;
    double edge;
};

Block block_of(System const& system, std::int64_t number, std::int64_t blocks_per_side) {
    double const edge = system.accessible_side() / static_cast<double>(blocks_per_side);
    double const low = system.boundary == Boundary::walls ? system.diameter / 2 : 0;
    auto const corner = [&](std::int64_t index) {
        return low + edge * static_cast<double>(index % blocks_per_side);
    };
    return {{corner(number), corner(number / blocks_per_side),
             corner(number / (blocks_per_side * blocks_per_side))},
            edge};
}

Eigen::Vector3d draw_place(Block const& block, Generator& generator) {
    double const x = block.corner.x() + block.edge * uniform(generator);
    double const y = block.corner.y() + block.edge * uniform(generator);
    double const z = block.corner.z() + block.edge * uniform(generator);
    return {x, y, z};
}

/// Balls of `diameter`, in the room that balls of the system's own diameter have between walls; or
/// nothing when a ball finds no place.
std::optional<Eigen::Matrix3Xd> insert_balls(System const& system, double diameter,
                                             Generator& generator) {
    std::int64_t const per_side = std::max<std::int64_t>(
        1,
        static_cast<std::int64_t>(cube_root(static_cast<double>(system.count) / balls_per_block)));
    std::int64_t const blocks = per_side * per_side * per_side;
    // Dilute: cells for a ball or two, not a thousand empty ones each.
    double const mean_spacing = system.side / cube_root(static_cast<double>(system.count));
    NearPlaces near(system, std::max(diameter, mean_spacing), system.count);
    Eigen::Matrix3Xd places(3, system.count);
    auto const is_free = [&](Eigen::Vector3d const& place) {
        bool free = true;
        near.visit_near(place, [&](std::int32_t other) {
            free = squared_length(separation_of(system, place, places.col(other))) >=
                   diameter * diameter;
            return free ? NearPlaces::Visit::go_on : NearPlaces::Visit::stop;
        });
        return free;
    };
    Eigen::Index ball = 0;
    for (std::int64_t number = 0; number < blocks; ++number) {
        Block const block = block_of(system, number, per_side);
        for (; ball < (number + 1) * system.count / blocks; ++ball) {
            int draws = 0;
            do {
                if (++draws > most_draws) return std::nullopt;
                places.col(ball) = draw_place(block, generator);
            } while (!is_free(places.col(ball)));
            near.add(places.col(ball));
        }
    }
    return places;
}

/// Diameter at which the balls fill `insertion_limit` of the room that their centres have.
double easily_inserted_diameter(System const& system) {
    double const room = system.accessible_side();
    return room *
           cube_root(insertion_limit * 6 / std::numbers::pi / static_cast<double>(system.count));
}

} // namespace

Eigen::Matrix3Xd place_at_random(System const& system, std::uint64_t seed) {
    Generator generator = make_generator(seed, Stream::places);
    bool const few = system.count <= a_few;
    for (int attempts_left = few ? attempts_of_a_few : 1;; --attempts_left) {
        double diameter =
            few ? system.diameter : std::min(system.diameter, easily_inserted_diameter(system));
        auto places = insert_balls(system, diameter, generator);
        while (!places) {
            diameter *= 0.9; // a few balls can block a small cube: begin again with smaller ones
            places = insert_balls(system, diameter, generator);
        }
        if (diameter == system.diameter) return *places;
        try {
            return grow_balls(system, *places, diameter, generator());
        } catch (LawBroken const&) {
            if (attempts_left == 1) throw;
        }
    }
}

} // namespace clack
