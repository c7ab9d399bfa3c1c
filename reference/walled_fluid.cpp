#include "reference/walled_fluid.hpp"

#include "reference/equation_of_state.hpp"
#include "reference/published_table.hpp"

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace clack::reference {

namespace {

using std::numbers::pi;

double tension(double density) {
    double const eta = pi * density / 6;
    return -9 / (2 * pi) * eta * eta * (1 + eta) / std::pow(1 - eta, 3);
}

/// Balls that a unit of a wall's area holds beyond the bulk's: -(dgamma/drho) / (dmu/drho), with
/// dmu/drho = (dP/drho) / rho.
double adsorption(double density) {
    double const eta = pi * density / 6;
    double const derivative = (2 * eta + 3 * eta * eta) / std::pow(1 - eta, 3) +
                              3 * eta * eta * (1 + eta) / std::pow(1 - eta, 4);
    double const tension_slope = -9 / (2 * pi) * derivative * pi / 6;
    return -tension_slope * density / modified_klm_pressure(density).slope;
}

double balls_in(double accessible, double density) {
    return density * accessible * accessible * accessible +
           6 * accessible * accessible * adsorption(density);
}

/// A column of wall_tension.csv against the density, 0 at 0.
class WallTerm {
public:
    explicit WallTerm(std::string const& name) : spline_(of_table(name)) {}
    double operator()(double const density) const { return spline_(density); }

private:
    using Spline = boost::math::interpolators::cardinal_cubic_b_spline<double>;
    static Spline of_table(std::string const& name) {
        auto const table = PublishedTable::of_reference("wall_tension.csv");
        std::vector<double> values = table.column(name);
        values.insert(values.begin(), 0);
        return {values.data(), values.size(), 0, table.column("number_density").front()};
    }
    Spline spline_;
};

/// The argument at which a rising function has a value, in [0, high].
template <class Function> double inverse(Function const& f, double const value, double high) {
    double low = 0;
    constexpr int halvings = 60;
    for (int k = 0; k < halvings; ++k) {
        double const middle = (low + high) / 2;
        (f(middle) < value ? low : high) = middle;
    }
    return low;
}

constexpr double side_min = 5;

} // namespace

double walled_compressibility(double side, double count) {
    if (!(side >= side_min) || !(count >= 2))
        throw std::invalid_argument("walled_compressibility: side or count too small");
    double const accessible = side - 1;
    double const volume = accessible * accessible * accessible;
    constexpr double densest = 0.54 * 6 / pi; // modified_klm's range
    if (balls_in(accessible, densest) < count)
        throw std::invalid_argument("walled_compressibility: denser than a fluid");
    auto const balls = [&](double const density) { return balls_in(accessible, density); };
    double const density = inverse(balls, count, densest);
    double const pressure =
        modified_klm_pressure(density).value - 4 * tension(density) / accessible;
    return pressure * volume / count;
}

WalledCubePressure walled_cube_pressure(double const side, double const count) {
    constexpr double densest = 0.92; // the table's end
    WallTerm const face_adsorption("adsorption"), face_tension("tension"),
        edge_adsorption("edge_adsorption"), edge_tension("edge_tension");
    double const l = side - 1;
    auto const balls = [&](double const density) {
        return density * l * l * l + 6 * l * l * face_adsorption(density) +
               12 * l * edge_adsorption(density);
    };
    if (!(side >= side_min && count >= 2 && balls(densest) > count)) {
        throw std::invalid_argument(
            fmt::format("side = {}, count = {}: the pressure on walls is known from side {} and "
                        "count 2 up to a bulk density of {}",
                        side, count, side_min, densest));
    }
    double const density = inverse(balls, count, densest);
    Pressure const bulk = modified_klm_pressure(density);
    return {.bulk_density = density,
            .bulk = bulk.value,
            .faces = -4 * face_tension(density) / l,
            .edges = -4 * edge_tension(density) / (l * l),
            .canonical = -density / (2 * l * l * l) * bulk.curvature / bulk.slope};
}

} // namespace clack::reference
