#include "scenes/lattice.hpp"

#include "scenes/packing.hpp"

namespace clack {

Eigen::Matrix3Xd place_on_grid(System const& system) {
    std::int64_t const sites = grid_sites_per_side(system.count);
    double const spacing = system.side / static_cast<double>(sites);
    Eigen::Matrix3Xd positions(3, system.count);
    for (std::int64_t ball = 0; ball < system.count; ++ball) {
        std::int64_t const x = ball % sites, y = ball / sites % sites, z = ball / (sites * sites);
        Eigen::Array3d const site(static_cast<double>(x), static_cast<double>(y),
                                  static_cast<double>(z));
        positions.col(ball) = ((site + 0.5) * spacing).matrix();
    }
    return positions;
}

Eigen::Matrix3Xd place_on_fcc(System const& system) {
    std::int64_t const layers = fcc_layers_per_side(system.boundary, system.count);
    std::int64_t const sites = fcc_site_count(layers);
    double const distance = fcc_layer_distance(system, layers);
    double const centred = static_cast<double>(layers - 1) / 2;
    Eigen::Matrix3Xd positions(3, system.count);
    std::int64_t site = 0, ball = 0;
    // The sites are the points of the layers' grid whose coordinates add up to an even number.
    for (std::int64_t z = 0; z < layers; ++z) {
        for (std::int64_t y = 0; y < layers; ++y) {
            for (std::int64_t x = (y + z) % 2; x < layers; x += 2, ++site) {
                // Ball number b takes site floor(b sites / count): gaps spread evenly.
                if (ball == system.count || site != ball * sites / system.count) continue;
                Eigen::Array3d const steps(static_cast<double>(x) - centred,
                                           static_cast<double>(y) - centred,
                                           static_cast<double>(z) - centred);
                positions.col(ball++) = (system.side / 2 + steps * distance).matrix();
            }
        }
    }
    return positions;
}

} // namespace clack
