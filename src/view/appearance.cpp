#include "view/appearance.hpp"

#include "view/images.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace clack::view {

namespace {

Eigen::Vector3f in_sides(Eigen::Vector3d const& place, System const& system) {
    return (place / system.side).cast<float>();
}

double mean_energy(Frame const& frame) {
    return frame.sample.kinetic_energy / static_cast<double>(frame.system.count);
}

Colour colour_of(Frame const& frame, Colouring colouring, double top, Eigen::Index ball) {
    auto const& velocity = frame.snapshot.velocities.col(ball);
    switch (colouring) {
    case Colouring::speed:
        return scale_colour(velocity.norm() / top);
    case Colouring::energy:
        return scale_colour(0.5 * frame.system.mass * velocity.squaredNorm() / top);
    case Colouring::collisions:
        if (frame.pasts.empty()) return {150, 150, 150};
        return scale_colour(frame.pasts[static_cast<std::size_t>(ball)].collisions / top);
    default:
        return (*frame.start_places)(0, ball) < frame.system.side / 2 ? left_colour : right_colour;
    }
}

std::uint8_t glow_of(Frame const& frame, Look const& look, Eigen::Index ball) {
    if (frame.pasts.empty()) return 0;
    double const last = frame.pasts[static_cast<std::size_t>(ball)].last_time;
    double const waits = std::max(frame.snapshot.time - last, 0.0) / look.flash_wait;
    constexpr double dark = 6; // then less than one in 255 is left
    return waits > dark ? 0 : static_cast<std::uint8_t>(255 * std::exp(-waits));
}

void add_cube(Picture& picture, Background background) {
    Colour const colour =
        background == Background::light ? Colour{70, 75, 80} : Colour{190, 195, 200};
    for (int axis = 0; axis < 3; ++axis) {
        for (int corner = 0; corner < 4; ++corner) {
            Eigen::Vector3f from = Eigen::Vector3f::Zero();
            from[(axis + 1) % 3] = static_cast<float>(corner & 1);
            from[(axis + 2) % 3] = static_cast<float>(corner >> 1);
            Eigen::Vector3f const to = from + Eigen::Vector3f::Unit(axis);
            picture.lines.push_back({from, to, colour, 1.6f, DrawnLine::Hiding::by_balls});
        }
    }
}

void add_cut_frame(Picture& picture) {
    Colour const colour{204, 121, 167};
    auto const corner = [&](int k) {
        Eigen::Vector3f place = Eigen::Vector3f::Zero();
        int const axis = picture.cut.axis();
        place[axis] = picture.cut.plane();
        place[(axis + 1) % 3] = k % 4 == 1 || k % 4 == 2 ? 1.f : 0.f;
        place[(axis + 2) % 3] = k % 4 >= 2 ? 1.f : 0.f;
        return place;
    };
    for (int k = 0; k < 4; ++k) {
        picture.lines.push_back(
            {corner(k), corner(k + 1), colour, 1.4f, DrawnLine::Hiding::by_balls});
    }
}

/// A flight that leaves a periodic cube goes on at the other side: one line for each crossing.
void add_flight(Picture& picture, System const& system, Eigen::Vector3d from,
                Eigen::Vector3d const& velocity, double duration) {
    Colour const colour =
        picture.background == Background::light ? Colour{213, 94, 0} : Colour{255, 160, 60};
    constexpr int crossings_max = 64;
    for (int crossing = 0; crossing < crossings_max && duration > 0; ++crossing) {
        double wait = duration;
        int exit = -1;
        for (int axis = 0; axis < 3 && system.boundary == Boundary::periodic; ++axis) {
            double const room = velocity[axis] > 0 ? system.side - from[axis] : -from[axis];
            double const until = velocity[axis] == 0 ? duration : room / velocity[axis];
            if (until < wait) {
                wait = until;
                exit = axis;
            }
        }
        Eigen::Vector3d to = from + velocity * wait;
        picture.lines.push_back(
            {in_sides(from, system), in_sides(to, system), colour, 2.f, DrawnLine::Hiding::never});
        if (exit >= 0) to[exit] = velocity[exit] > 0 ? 0 : system.side;
        from = to;
        duration -= wait;
    }
}

void add_path(Picture& picture, Frame const& frame) {
    for (std::size_t k = 0; k < frame.path.size(); ++k) {
        Bend const& bend = frame.path[k];
        double const end = k + 1 < frame.path.size() ? frame.path[k + 1].time : frame.snapshot.time;
        add_flight(picture, frame.system, bend.place, bend.velocity, end - bend.time);
    }
}

void add_marks(Picture& picture, Frame const& frame, Look const& look) {
    // The next pair's are wider, to be seen about those of the ball that is followed.
    constexpr float single = 1, pair = 1.15f;
    auto const ring = [&](std::int64_t ball, Colour colour, float width) {
        if (ball < 0 || ball >= frame.system.count) return;
        each_place(frame.system, frame.snapshot.positions.col(ball),
                   [&](Eigen::Vector3f const& place) {
                       picture.rings.push_back({place, colour, width});
                   });
    };
    if (look.next_pair == Visible::yes && frame.next) {
        ring(frame.next->first, pair_colour, pair);
        ring(frame.next->second, pair_colour, pair);
    }
    if (frame.traced >= 0) {
        add_path(picture, frame);
        ring(frame.traced,
             look.background == Background::light ? Colour{0, 0, 0} : Colour{255, 255, 255},
             single);
        if (frame.next_of_traced) {
            auto const& next = *frame.next_of_traced;
            ring(next.first == frame.traced ? next.second : next.first, partner_colour, single);
        }
    }
}

} // namespace

Colour scale_colour(double share) {
    // Viridis (S. van der Walt, N. Smith, 2015) from a quarter on: what is darker, balls at rest
    // as a rule, would not be seen before the window's background.
    constexpr std::array<std::array<double, 3>, 8> table{{{59, 82, 139},
                                                          {47, 108, 142},
                                                          {37, 132, 142},
                                                          {31, 158, 137},
                                                          {53, 183, 121},
                                                          {110, 206, 88},
                                                          {181, 222, 43},
                                                          {253, 231, 37}}};
    double const at = std::clamp(share, 0.0, 1.0) * static_cast<double>(table.size() - 1);
    auto const below = std::min(static_cast<std::size_t>(at), table.size() - 2);
    double const part = at - static_cast<double>(below);
    Colour colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        colour[c] = static_cast<std::uint8_t>(
            std::lround((1 - part) * table[below][c] + part * table[below + 1][c]));
    }
    return colour;
}

double scale_top(Frame const& frame, Colouring colouring) {
    double const energy = std::max(mean_energy(frame), 1e-300);
    switch (colouring) {
    case Colouring::speed: // hardly any ball of a gas is twice as fast as most
        return 2 * std::sqrt(2 * energy / frame.system.mass);
    case Colouring::energy:
        return 4 * energy;
    case Colouring::collisions: {
        double most = 1;
        for (Past const& past : frame.pasts) most = std::max<double>(most, past.collisions);
        return most;
    }
    default:
        return 1;
    }
}

Picture picture_of(Frame const& frame, Look const& look) {
    std::vector<Eigen::Index> all(static_cast<std::size_t>(frame.system.count));
    std::iota(all.begin(), all.end(), 0);
    return picture_of(frame, look, all);
}

Picture picture_of(Frame const& frame, Look const& look, std::vector<Eigen::Index> const& balls) {
    Picture picture;
    System const& system = frame.system;
    picture.background = look.background;
    picture.radius = static_cast<float>(system.diameter / system.side / 2);
    picture.cut = look.cut;
    double const top = scale_top(frame, look.colouring);
    picture.balls.reserve(balls.size());
    for (Eigen::Index const ball : balls) {
        auto const glow =
            look.flashes == Visible::yes ? glow_of(frame, look, ball) : std::uint8_t{};
        auto const colour = colour_of(frame, look.colouring, top, ball);
        each_place(system, frame.snapshot.positions.col(ball), [&](Eigen::Vector3f const& place) {
            picture.balls.push_back({place.x(), place.y(), place.z(), colour, glow});
        });
    }
    if (look.cube == Visible::yes) add_cube(picture, look.background);
    if (!look.cut.is_whole()) add_cut_frame(picture);
    add_marks(picture, frame, look);
    return picture;
}

} // namespace clack::view
