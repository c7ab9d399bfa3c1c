#pragma once
// A straight line through points, by least squares.

#include "validation/harness/interval.hpp"

#include <gsl/gsl_fit.h>

#include <cmath>
#include <vector>

namespace clack::validation {

struct StraightLine {
    double at_0 = 0, slope = 0;
};

inline StraightLine line_through(std::vector<double> const& x, std::vector<double> const& y) {
    StraightLine line;
    double c00 = 0, c01 = 0, c11 = 0, squares = 0;
    gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &line.at_0, &line.slope, &c00, &c01, &c11,
                   &squares);
    return line;
}

/// The same with errors, from those of the points.
struct MeasuredLine {
    Estimate at_0, slope;
};

inline MeasuredLine line_through(std::vector<double> const& x, std::vector<Estimate> const& y) {
    std::vector<double> values, weights;
    for (Estimate const& point : y) {
        values.push_back(point.value);
        weights.push_back(1 / (point.error * point.error));
    }
    MeasuredLine line;
    double c00 = 0, c01 = 0, c11 = 0, squares = 0;
    gsl_fit_wlinear(x.data(), 1, weights.data(), 1, values.data(), 1, x.size(), &line.at_0.value,
                    &line.slope.value, &c00, &c01, &c11, &squares);
    line.at_0.error = std::sqrt(c00);
    line.slope.error = std::sqrt(c11);
    return line;
}

} // namespace clack::validation
