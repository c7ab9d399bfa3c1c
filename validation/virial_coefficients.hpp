#pragma once
// Virial coefficients from runs of dilute fluids: state points, the fit, and what it should give.

#include "reference/published_table.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/periodic_run.hpp"

#include <Eigen/QR>

#include <array>
#include <cmath>
#include <vector>

namespace clack::validation::virial_coefficients {

/// Packing fractions of the fit, where they tell most of three coefficients: at both ends and in
/// the middle. Up to the highest, the series to the twelfth order is right to 1e-5.
inline std::vector<PeriodicRun> runs(Profile const profile) {
    double const longer = profile == Profile::quick ? 1 : 20;
    std::vector<PeriodicRun> runs;
    for (double const eta : {0.01, 0.015, 0.02, 0.025, 0.11, 0.12, 0.22, 0.23})
        runs.push_back({{eta, 256}, 30, 1800 * longer});
    return runs;
}

/// What is fitted, in powers of the packing fraction; the orders above are taken from literature.
constexpr std::size_t fitted = 3; // B2, B3, B4
constexpr int lowest_order = 2;

/// (Z - 1) / eta of infinitely many balls less what the known higher orders give: B2 + B3 eta +
/// B4 eta^2. The finite-size law is small, and right to the second order at these densities.
inline double low_orders(PeriodicRun const& run, double const compressibility) {
    static auto const table = reference::PublishedTable::of_reference("virial_coefficients.csv");
    double const eta = run.packing_fraction;
    double const to_infinite = run.expected_of_infinitely_many() - run.expected();
    double sum = (compressibility + to_infinite - 1) / eta;
    for (std::size_t k = fitted; k < table.row_count(); ++k)
        sum -=
            table.column("coefficient")[k] * std::pow(eta, table.column("order")[k] - lowest_order);
    return sum;
}

/// B2, B3, B4 by least squares from one replicate of each run, every point with the weight of its
/// number of collisions, which is the same.
inline std::array<double, fitted> fit(std::vector<PeriodicRun> const& runs,
                                      std::vector<double> const& compressibilities) {
    auto const count = static_cast<Eigen::Index>(runs.size());
    Eigen::MatrixXd powers(count, fitted);
    Eigen::VectorXd values(count);
    for (Eigen::Index k = 0; k < count; ++k) {
        auto const& run = runs[static_cast<std::size_t>(k)];
        double const value = low_orders(run, compressibilities[static_cast<std::size_t>(k)]);
        values[k] = value;
        for (Eigen::Index power = 0; power < powers.cols(); ++power)
            powers(k, power) = std::pow(run.packing_fraction, static_cast<double>(power));
    }
    // The errors are equal as parts of Zc, so each row is taken in units of its value.
    for (Eigen::Index k = 0; k < count; ++k) powers.row(k) /= values[k];
    Eigen::VectorXd const best = powers.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(count));
    return {best[0], best[1], best[2]};
}

/// Z of N balls, from the rate of the collisions, which scatters less than their virial.
inline Measurement measure(PeriodicRun const& run, std::uint64_t const seed,
                           EngineMaker const& make = make_true_engine) {
    auto const engine = make(run.scene(seed));
    auto const twice = run_periodic(run, *engine);
    return {twice.by_rate, twice.by_virial};
}

/// Margins as parts of B2, B3, B4: for B2 half of what a diameter wrong by 0.1 % does to it,
/// for the others some five standard errors; in the full profile, whose errors are, four times
/// smaller.
constexpr std::array<double, fitted> margins{1.5e-3, 3e-2, 8e-2};
constexpr double part_of_margin(Profile const profile) {
    return profile == Profile::quick ? 1 : 0.25;
}

/// The coefficients of all replicates beside the exact ones. `all` holds the replicates run by run.
inline void enter(Ledger& ledger, std::vector<PeriodicRun> const& runs,
                  std::vector<std::vector<Measurement>> const& all, Profile const profile) {
    std::array<std::vector<double>, fitted> coefficients;
    for (std::size_t replicate = 0; replicate < all.front().size(); ++replicate) {
        std::vector<double> compressibilities;
        for (auto const& of_run : all) compressibilities.push_back(of_run[replicate][0]);
        auto const fitted_now = fit(runs, compressibilities);
        for (std::size_t k = 0; k < fitted; ++k) coefficients[k].push_back(fitted_now[k]);
    }
    auto const table = reference::PublishedTable::of_reference("virial_coefficients.csv");
    for (std::size_t k = 0; k < fitted; ++k) {
        double const order = table.column("order")[k], exact = table.column("coefficient")[k];
        ledger.compare({cell(order)},
                       {fmt::format("B{:.0f}", order), fmt::format("$B_{:.0f}$", order)},
                       {.measured = mean_of(coefficients[k]),
                        .reference = exact,
                        .margin = part_of_margin(profile) * margins[k] * exact});
    }
}

} // namespace clack::validation::virial_coefficients
