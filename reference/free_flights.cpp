#include "reference/free_flights.hpp"

#include <cmath>
#include <numbers>

namespace clack::reference::free_flights {

namespace {

/// Mean over Maxwell's law of speeds. The trapezoids of a function that is flat at both ends
/// converge faster than any power of the step.
template <class Function> double maxwell_mean(Function const& of_speed) {
    constexpr double step = 0.01, top = 14;
    double sum = 0;
    for (double v = step; v < top; v += step) sum += v * v * std::exp(-v * v / 2) * of_speed(v);
    return std::sqrt(2 / std::numbers::pi) * sum * step;
}

double factorial(int const k) { return std::tgamma(k + 1.0); }

} // namespace

double relative_rate(double const speed) {
    double const slow = std::sqrt(2 / std::numbers::pi);
    double const rate = speed < 1e-4
                            ? 2 * slow // the limit, to 1e-9
                            : slow * std::exp(-speed * speed / 2) +
                                  (speed + 1 / speed) * std::erf(speed * std::numbers::sqrt2 / 2);
    return rate * std::sqrt(std::numbers::pi) / 4;
}

double time_density(double const time) {
    return maxwell_mean([&](double const v) {
        double const rate = relative_rate(v);
        return rate * rate * std::exp(-rate * time);
    });
}

double time_survival(double const time) {
    return maxwell_mean([&](double const v) { return std::exp(-relative_rate(v) * time); });
}

double time_moment(int const power) {
    return factorial(power) *
           maxwell_mean([&](double const v) { return std::pow(relative_rate(v), 1 - power); });
}

double length_moment(int const power) {
    double const mean_speed = std::sqrt(8 / std::numbers::pi);
    return factorial(power) / std::pow(mean_speed, power) * maxwell_mean([&](double const v) {
               return std::pow(v, power) * std::pow(relative_rate(v), 1 - power);
           });
}

} // namespace clack::reference::free_flights
