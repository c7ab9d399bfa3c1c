#include "observables/blocking.hpp"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace clack {

namespace {

struct Interval {
    double duration, gain;
};

/// Standard error of total gain / total duration if the blocks were independent.
double naive_error(std::vector<Interval> const& blocks, double rate) {
    double squares = 0;
    double duration = 0;
    for (auto const& block : blocks) {
        double const excess = block.gain - rate * block.duration;
        squares += excess * excess;
        duration += block.duration;
    }
    auto const count = static_cast<double>(blocks.size());
    return std::sqrt(squares * count / (count - 1)) / duration;
}

/// Pairs of neighbours joined; an odd one at the end is left out.
std::vector<Interval> merged(std::vector<Interval> const& blocks) {
    std::vector<Interval> pairs;
    for (std::size_t i = 0; i + 1 < blocks.size(); i += 2) {
        pairs.push_back(
            {blocks[i].duration + blocks[i + 1].duration, blocks[i].gain + blocks[i + 1].gain});
    }
    return pairs;
}

struct Level {
    double error, uncertainty;
};

} // namespace

Estimate rate_by_blocking(std::span<double const> times, std::span<double const> sums) {
    assert(times.size() == sums.size());
    if (times.empty() || !(times.back() > times.front())) return {};
    double const rate = (sums.back() - sums.front()) / (times.back() - times.front());

    std::vector<Interval> blocks;
    for (std::size_t i = 1; i < times.size(); ++i) {
        blocks.push_back({times[i] - times[i - 1], sums[i] - sums[i - 1]});
    }
    std::vector<Level> levels;
    for (; blocks.size() >= block_count_min; blocks = merged(blocks)) {
        double const error = naive_error(blocks, rate);
        double const freedom = static_cast<double>(blocks.size() - 1);
        levels.push_back({error, error / std::sqrt(2 * freedom)});
    }
    for (std::size_t shortest = 0; shortest < levels.size(); ++shortest) {
        bool levelled_off = true;
        for (std::size_t longer = shortest + 1; longer < levels.size(); ++longer) {
            auto const& level = levels[longer];
            levelled_off &= level.error - level.uncertainty <= levels[shortest].error;
        }
        if (levelled_off) return {rate, levels[shortest].error};
    }
    return {rate, std::nullopt};
}

} // namespace clack
