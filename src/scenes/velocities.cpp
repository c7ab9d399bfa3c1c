#include "scenes/velocities.hpp"

#include "scenes/draw.hpp"

#include <cmath>

namespace clack {

namespace {

/// Sum whose rounding does not grow with the number of terms (Neumaier, Z. Angew. Math. Mech. 54,
/// 39 (1974)): a million balls have their temperature to the last digits.
class CompensatedSum {
public:
    void add(double term) {
        double const sum = sum_ + term;
        lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
        sum_ = sum;
    }
    double value() const { return sum_ + lost_; }

private:
    double sum_ = 0, lost_ = 0;
};

/// Points in a disc of radius 1 by rejection, and their squared distance from its centre.
struct DiscPoint {
    double x, y, squared;
};
DiscPoint draw_in_disc(Generator& generator) {
    for (;;) {
        double const x = uniform_about_zero(generator);
        double const y = uniform_about_zero(generator);
        double const squared = x * x + y * y;
        if (squared > 0 && squared < 1) return {x, y, squared};
    }
}

void remove_momentum(Eigen::Matrix3Xd& velocities) {
    // The second pass removes what rounding has left of the first.
    for (int pass = 0; pass < 2; ++pass) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            CompensatedSum sum;
            for (Eigen::Index ball = 0; ball < velocities.cols(); ++ball)
                sum.add(velocities(axis, ball));
            velocities.row(axis).array() -= sum.value() / static_cast<double>(velocities.cols());
        }
    }
}

/// Momentum and temperature as they are asked for.
Eigen::Matrix3Xd settled(System const& system, double temperature, Eigen::Matrix3Xd velocities) {
    if (system.boundary == Boundary::periodic && system.count > 1) remove_momentum(velocities);
    velocities *= std::sqrt(temperature / temperature_of(system, velocities));
    return velocities;
}

} // namespace

double temperature_of(System const& system, Eigen::Matrix3Xd const& velocities) {
    CompensatedSum sum;
    for (double const component : velocities.reshaped()) sum.add(component * component);
    return system.mass * sum.value() / system.degrees_of_freedom();
}

Eigen::Matrix3Xd draw_maxwell_velocities(System const& system, double temperature,
                                         std::uint64_t seed) {
    Generator generator = make_generator(seed, Stream::velocities);
    Eigen::Matrix3Xd velocities(3, system.count);
    // Marsaglia's polar method gives two normal numbers at a time (SIAM Rev. 6, 260 (1964)).
    for (Eigen::Index number = 0; number < velocities.size(); number += 2) {
        auto const [x, y, squared] = draw_in_disc(generator);
        // Logarithms differ between mathematics libraries in the last bit of a double.
        double const logarithm = static_cast<float>(std::log(squared));
        double const stretch = std::sqrt(-2 * logarithm / squared);
        velocities.reshaped()[number] = x * stretch;
        if (number + 1 < velocities.size()) velocities.reshaped()[number + 1] = y * stretch;
    }
    return settled(system, temperature, std::move(velocities));
}

Eigen::Matrix3Xd draw_equal_speeds(System const& system, double temperature, std::uint64_t seed) {
    Generator generator = make_generator(seed, Stream::velocities);
    Eigen::Matrix3Xd velocities(3, system.count);
    // A disc's points onto the sphere (Marsaglia, Ann. Math. Stat. 43, 645 (1972)).
    for (Eigen::Index ball = 0; ball < velocities.cols(); ++ball) {
        auto const [x, y, squared] = draw_in_disc(generator);
        double const width = 2 * std::sqrt(1 - squared);
        velocities.col(ball) << x * width, y * width, 1 - 2 * squared;
    }
    return settled(system, temperature, std::move(velocities));
}

} // namespace clack
