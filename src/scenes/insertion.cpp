#include "scenes/insertion.hpp"

#include "scenes/draw.hpp"
#include "scenes/message.hpp"
#include "scenes/near_places.hpp"
#include "scenes/packing.hpp"
#include "simulation/growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace clack {

namespace {

/// Insertion ends near 0.38, where no hole is left; up to here it takes a few draws a ball.
constexpr double insertion_limit = 0.25;

/// Draws for one ball before the start is given up for smaller balls.
constexpr int most_draws = 2000;

Eigen::Vector3d draw_place(System const& system, Generator& generator) {
    double const low = system.boundary == Boundary::walls ? system.diameter / 2 : 0;
    double const x = low + system.accessible_side() * uniform(generator);
    double const y = low + system.accessible_side() * uniform(generator);
    double const z = low + system.accessible_side() * uniform(generator);
    return {x, y, z};
}

/// Balls of `diameter`, in the room that balls of the system's own diameter have between walls.
std::optional<Eigen::Matrix3Xd> insert_balls(System const& system, double diameter,
                                             Generator& generator) {
    NearPlaces near(system, diameter, system.count);
    Eigen::Matrix3Xd places(3, system.count);
    double const contact = diameter * diameter;
    for (Eigen::Index ball = 0; ball < system.count; ++ball) {
        bool free = false;
        for (int draw = 0; draw < most_draws && !free; ++draw) {
            Eigen::Vector3d const place = draw_place(system, generator);
            free = true;
            near.visit_near(place, [&](std::int32_t other) {
                free = squared_length(separation_of(system, place, places.col(other))) >= contact;
                return free ? NearPlaces::Visit::go_on : NearPlaces::Visit::stop;
            });
            places.col(ball) = place;
        }
        if (!free) return std::nullopt;
        near.add(places.col(ball));
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
    double diameter = std::min(system.diameter, easily_inserted_diameter(system));
    auto places = insert_balls(system, diameter, generator);
    while (!places) {
        diameter *= 0.9; // a few balls can block a small cube: begin again with smaller ones
        places = insert_balls(system, diameter, generator);
    }
    if (diameter == system.diameter) return *places;
    try {
        return grow_balls(system, *places, diameter, generator());
    } catch (LawBroken const& jam) {
        throw input_error(fmt::format(
            "arrangement = \"random\": {} balls at packing fraction {:.4g} jam while they grow "
            "({}); take a larger cube, another seed, or arrangement = \"fcc\"",
            system.count, system.packing_fraction(), jam.what()));
    }
}

} // namespace clack
