#pragma once
// The names of what a scene file says.

#include <string_view>

namespace clack {

/// `name` in `[section]`; at the top of the file where the section is empty.
struct Key {
    std::string_view section, name;
};

namespace key {

constexpr Key title{"", "title"};
constexpr Key boundary{"container", "boundary"}, side{"container", "side"},
    packing_fraction{"container", "packing_fraction"};
constexpr Key count{"balls", "count"}, diameter{"balls", "diameter"}, mass{"balls", "mass"},
    arrangement{"balls", "arrangement"}, positions{"balls", "positions"},
    start_path{"balls", "path"};
constexpr Key distribution{"velocities", "distribution"}, temperature{"velocities", "temperature"},
    velocities{"velocities", "velocities"}, velocity_path{"velocities", "path"};
constexpr Key seed{"run", "seed"}, equilibrate{"run", "equilibrate"},
    collisions_per_ball{"run", "collisions_per_ball"}, time{"run", "time"},
    collisions{"run", "collisions"}, method{"run", "method"}, precision{"run", "precision"};
constexpr Key frame_interval{"output", "frame_interval"}, events{"output", "events"};

} // namespace key

} // namespace clack
