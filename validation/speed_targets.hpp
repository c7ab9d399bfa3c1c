#pragma once
// What is asked of the rates, and whether it is so.

#include "validation/harness/ledger.hpp"
#include "validation/speed.hpp"

namespace clack::validation::speed {

/// A state point with what was measured there.
struct Found {
    Point point;
    std::vector<Measurement> replicates;

    std::vector<std::string> state(std::size_t const boundary) const {
        return {name_of(boundaries[boundary]), cell(point.count), cell(point.packing_fraction)};
    }
    /// Whether it ran there, each time.
    bool has(std::size_t const boundary, std::size_t const runner) const {
        return std::none_of(replicates.begin(), replicates.end(), [=](Measurement const& all) {
            return std::isnan(all[place_of(boundary, runner)]);
        });
    }
    double mean(std::size_t const boundary, std::size_t const runner,
                std::size_t const value) const {
        return mean_of(replicates, place_of(boundary, runner, value)).value;
    }
    /// Collisions per second of processor time.
    Estimate rate(std::size_t const boundary, std::size_t const runner) const {
        return median_of(replicates, [=](Measurement const& all) {
            return 1 / all[place_of(boundary, runner)];
        });
    }
    /// How many times as fast one runner is as another, replicate by replicate.
    Estimate over(std::size_t const boundary, std::size_t const runner,
                  std::size_t const other_boundary, std::size_t const other) const {
        return median_of(replicates, [=](Measurement const& all) {
            return all[place_of(other_boundary, other)] / all[place_of(boundary, runner)];
        });
    }
};

constexpr double least = 0.9;      // of the rate of each other method
constexpr double over_heap = 5;    // times its rate, from `not_small` balls on: an aim
constexpr double growth_max = 2.5; // of a collision's cost from there on: an aim

/// How much more a collision costs than among `not_small` balls.
inline Estimate growth(Found const& few, Found const& many, std::size_t const boundary) {
    std::vector<double> ratios;
    std::size_t const place = place_of(boundary, fast);
    for (std::size_t k = 0; k < std::min(few.replicates.size(), many.replicates.size()); ++k)
        ratios.push_back(many.replicates[k][place] / few.replicates[k][place]);
    return median_of(ratios);
}

/// All that is asked of the fast method in one container. That it is the quickest is judged; the
/// aims are guides.
inline void enter(Ledger& ledger, std::vector<Found> const& all, Found const& found,
                  std::size_t const b) {
    auto const state = found.state(b);
    for (std::size_t const other : {heap, table}) {
        std::string const name = fmt::format("fast_over_{}", runners[other]);
        if (found.has(b, other))
            ledger.compare(state, {name, in_tex(name)},
                           {.measured = found.over(b, fast, b, other),
                            .reference = least,
                            .asks = Asks::whether_at_least});
    }
    auto const aim = [&](std::string const& name, Estimate const& factor, double const aimed_at) {
        ledger.guide(state, {name, in_tex(name)}, {.measured = factor, .reference = aimed_at});
    };
    if (b == in_walls) aim("walls_over_periodic", found.over(b, fast, in_periodic, fast), least);
    if (found.point.count < not_small) return;
    aim("aim_over_heap", found.over(b, fast, b, heap), over_heap);
    for (Found const& few : all)
        if (few.point.packing_fraction == found.point.packing_fraction &&
            few.point.count == not_small && few.point.count < found.point.count)
            aim("growth", growth(few, found, b), growth_max);
}

/// The account of all points, judged.
inline Ledger ledger_of(std::vector<Found> const& all) {
    Ledger ledger({{"boundary", ""}, {"count", "$n$"}, {"packing_fraction", "$\\eta$"}});
    for (Found const& found : all)
        for (std::size_t b = 0; b < boundaries.size(); ++b) enter(ledger, all, found, b);
    ledger.judge(of_timing);
    return ledger;
}

/// Which points have something undecided.
inline std::vector<bool> undecided(std::vector<Found> const& all) {
    Ledger const ledger = ledger_of(all);
    std::vector<bool> open;
    for (Found const& found : all)
        open.push_back(ledger.verdict_at(found.state(in_periodic)) == Verdict::undecided ||
                       ledger.verdict_at(found.state(in_walls)) == Verdict::undecided);
    return open;
}

/// What is measured, from the campaign as far as it has it; what stays undecided, again.
inline std::vector<Found> measured(Experiment& experiment) {
    std::string const peer_command = peer_of_environment();
    std::string with_peer = peer_command.empty() ? "" : " peer=" + peer_command;
    std::replace(with_peer.begin(), with_peer.end(), '|', ' '); // which ends a state point's text
    std::vector<Found> all;
    for (Point const& point : points(experiment.profile())) all.push_back({point, {}});
    measure_until_decided(
        all.size(),
        [&](std::size_t const k, int const times) {
            Point const& point = all[k].point;
            all[k].replicates = experiment.campaign().replicates(
                point.text() + with_peer, times * replicates,
                [&](std::uint64_t const seed) { return measure(point, seed, peer_command); });
        },
        [&] { return undecided(all); });
    return all;
}

} // namespace clack::validation::speed
