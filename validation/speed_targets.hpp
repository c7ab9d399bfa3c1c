#pragma once
// What is asked of the rates, and whether it is so.

#include "validation/harness/ratio.hpp"
#include "validation/speed.hpp"

namespace clack::validation::speed {

/// A state point with what was measured there.
struct Found {
    Point point;
    std::vector<Costs> replicates;

    /// Whether it ran there, each time.
    bool has(std::size_t const boundary, std::size_t const runner) const {
        return std::none_of(replicates.begin(), replicates.end(), [=](Costs const& costs) {
            return std::isnan(costs[boundary][runner].seconds);
        });
    }
    /// The median of one value a replicate.
    template <class Of> Estimate median(Of&& of) const {
        std::vector<double> values;
        for (Costs const& costs : replicates) values.push_back(of(costs));
        return median_of(values);
    }
    /// Collisions per second of processor time.
    Estimate rate(std::size_t const boundary, std::size_t const runner) const {
        return median([=](Costs const& costs) { return 1 / costs[boundary][runner].seconds; });
    }
    /// How many times as fast one runner is as another, replicate by replicate.
    Estimate over(std::size_t const boundary, std::size_t const runner,
                  std::size_t const other_boundary, std::size_t const other) const {
        return median([=](Costs const& costs) {
            return costs[other_boundary][other].seconds / costs[boundary][runner].seconds;
        });
    }
    double bytes(std::size_t const boundary, std::size_t const runner) const {
        return replicates.front()[boundary][runner].bytes;
    }
    /// Mean share of a part in the time.
    double share(std::size_t const boundary, std::size_t const runner,
                 std::size_t const part) const {
        double sum = 0;
        for (Costs const& costs : replicates) sum += costs[boundary][runner].shares[part];
        return sum / static_cast<double>(replicates.size());
    }
};

/// What a rate is compared with.
enum class Yardstick { heap, table, five_heaps, periodic, fewer_balls };

/// A factor between two rates that should not be less than something.
struct Target {
    Yardstick yardstick;
    Point point;
    std::size_t boundary;
    Estimate factor;
    Verdict verdict = Verdict::undecided;
};

constexpr std::int64_t not_small = 4'000; // balls, from where on targets hold
constexpr double over_heap = 5;           // times the heap's rate
constexpr double growth_max = 2.5;        // of a collision's cost from `not_small` balls on

/// Two of them are judged: `fast` is meant to be the quickest, and a tenth is what ratios on a
/// shared machine wander by. The others are aims, reported as reached or not.
constexpr bool is_judged(Yardstick const yardstick) {
    return yardstick == Yardstick::heap || yardstick == Yardstick::table;
}
constexpr double least_of(Yardstick const yardstick) {
    switch (yardstick) {
    case Yardstick::five_heaps:
        return over_heap;
    case Yardstick::fewer_balls:
        return 1 / growth_max;
    default:
        return 0.9;
    }
}
inline std::string name_of(Yardstick const yardstick) {
    switch (yardstick) {
    case Yardstick::heap:
        return "heap";
    case Yardstick::table:
        return "table";
    case Yardstick::five_heaps:
        return fmt::format("{:g} heaps", over_heap);
    case Yardstick::periodic:
        return "periodic";
    default:
        return fmt::format("of {} balls", not_small);
    }
}

/// Verdicts: of the aims each alone, then of those that are judged together, which alone count for
/// the experiment.
inline void decide(std::vector<Target>& targets) {
    std::vector<Comparison> together;
    for (Target& target : targets) {
        Comparison const asked = at_least(least_of(target.yardstick), target.factor);
        if (is_judged(target.yardstick))
            together.push_back(asked);
        else
            target.verdict = judge({asked}, of_timing).front().verdict;
    }
    forget_judged();
    auto const judgements = judge(together, of_timing);
    auto next = judgements.begin();
    for (Target& target : targets)
        if (is_judged(target.yardstick)) target.verdict = (next++)->verdict;
}

/// The point of the same packing fraction with `not_small` balls.
inline Found const* fewer_balls(std::vector<Found> const& all, Point const& point) {
    for (Found const& found : all)
        if (found.point.packing_fraction == point.packing_fraction &&
            found.point.count == not_small && found.point.count < point.count)
            return &found;
    return nullptr;
}

/// How the rate of a runner changes from one point to another.
inline Estimate growth(Found const& from, Found const& to, std::size_t const boundary,
                       std::size_t const runner) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < std::min(from.replicates.size(), to.replicates.size()); ++k)
        ratios.push_back(from.replicates[k][boundary][runner].seconds /
                         to.replicates[k][boundary][runner].seconds);
    return median_of(ratios);
}

/// All that is asked of the fast method.
inline std::vector<Target> targets_of(std::vector<Found> const& all) {
    std::vector<Target> targets;
    for (Found const& found : all) {
        for (std::size_t b = 0; b < boundaries.size(); ++b) {
            auto const add = [&](Yardstick const yardstick, Estimate const& factor) {
                targets.push_back({yardstick, found.point, b, factor});
            };
            Estimate const faster = found.over(b, fast, b, heap);
            add(Yardstick::heap, faster);
            if (found.has(b, table)) add(Yardstick::table, found.over(b, fast, b, table));
            if (found.point.count >= not_small) add(Yardstick::five_heaps, faster);
            if (b == in_walls)
                add(Yardstick::periodic, found.over(in_walls, fast, in_periodic, fast));
            if (Found const* const fewer = fewer_balls(all, found.point))
                add(Yardstick::fewer_balls, growth(*fewer, found, b, fast));
        }
    }
    decide(targets);
    return targets;
}

/// Whether anything that is judged of a state point is still open.
inline bool is_undecided(Point const& point, std::vector<Target> const& targets) {
    return std::any_of(targets.begin(), targets.end(), [&](Target const& target) {
        return is_judged(target.yardstick) && target.verdict == Verdict::undecided &&
               target.point.text() == point.text();
    });
}

} // namespace clack::validation::speed
