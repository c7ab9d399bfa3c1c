#pragma once
// Many small bins of balls in one allocation: book-keeping only, no physics.

#include "state/huge_pages.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace clack {

/// A bin is a block of `places` and, when that is full, a chain of further blocks from a pool:
/// nothing can overflow, and emptied blocks are used again.
template <std::int32_t places> class ChainedBins {
public:
    static_assert(places < 16);
    static constexpr std::int32_t end_of_chain = -1;

    /// Its balls, and in one number how many there are and where the chain goes on: what fits into
    /// half the memory is 1.03 to 1.06 times as fast.
    struct Block {
        std::array<std::int32_t, places> ball{};
        std::int32_t tail = 16 * end_of_chain;

        std::int32_t count() const { return tail & 15; }
        std::int32_t more() const { return tail >> 4; }
        bool is_last() const { return tail < 0; }
        void go_on_at(std::int32_t block) { tail = 16 * block + count(); }
        void add(std::int32_t one) { ball[static_cast<std::size_t>(tail++ & 15)] = one; }
    };

    /// So many bins, all empty.
    void reset(std::size_t bins) {
        if (bins >= blocks_max) throw std::length_error("too many bins");
        reserve_large(blocks_, bins + bins / 64);
        blocks_.assign(bins, Block{});
        free_ = end_of_chain;
        chained_ = 0;
    }

    void insert(std::size_t bin, std::int32_t ball) {
        if (!insert_in_first(bin, ball)) insert_in_chain(bin, ball);
    }
    /// Whether the bin's first block had room for it.
    bool insert_in_first(std::size_t bin, std::int32_t ball) {
        if (blocks_[bin].count() == places) return false;
        blocks_[bin].add(ball);
        return true;
    }

    /// The last ball of the chain takes the place that becomes free.
    void remove(std::size_t bin, std::int32_t ball) {
        Block& block = blocks_[bin];
        if (!block.is_last()) return remove_from_chain(bin, ball);
        std::size_t const place = find(block, ball);
        block.ball[place] = block.ball[static_cast<std::size_t>(--block.tail & 15)];
    }

    /// Empties a bin, block by block, into visit(balls, count). What is visited may be inserted
    /// anew, into this bin too.
    template <class Visit> void drain(std::size_t bin, Visit&& visit) {
        Block block = blocks_[bin];
        blocks_[bin].tail = 16 * end_of_chain;
        for (;;) {
            visit(block.ball.data(), static_cast<std::size_t>(block.count()));
            if (block.is_last()) return;
            std::int32_t const next = block.more();
            block = blocks_[static_cast<std::size_t>(next)];
            give_back(next);
        }
    }

    Block const& block(std::size_t bin) const { return blocks_[bin]; }

    /// How many blocks the bins have beyond their first ones.
    std::size_t chained() const { return chained_; }

    std::size_t bytes() const { return blocks_.capacity() * sizeof(Block); }

private:
    static constexpr std::size_t blocks_max = std::size_t{1} << 27; // what a tail can name

    /// The ball's place, or how many there are. It looks at all: where it will be found cannot be
    /// foretold.
    static std::size_t find(Block const& block, std::int32_t ball) {
        auto const count = static_cast<std::size_t>(block.count());
        std::size_t found = count;
        for (std::size_t place = 0; place < places; ++place) {
            std::size_t const here = (block.ball[place] == ball) & (place < count);
            found ^= (found ^ place) & (0 - here);
        }
        return found;
    }

    [[gnu::noinline]] void insert_in_chain(std::size_t bin, std::int32_t ball) {
        while (blocks_[bin].count() == places) {
            if (blocks_[bin].is_last()) {
                std::int32_t const fresh = take_block();
                blocks_[bin].go_on_at(fresh);
            }
            bin = static_cast<std::size_t>(blocks_[bin].more());
        }
        blocks_[bin].add(ball);
    }

    [[gnu::noinline]] void remove_from_chain(std::size_t bin, std::int32_t ball) {
        std::size_t last = bin, before = bin, found = bin;
        std::size_t place = find(blocks_[bin], ball);
        while (!blocks_[last].is_last()) {
            before = last;
            last = static_cast<std::size_t>(blocks_[last].more());
            if (place == static_cast<std::size_t>(blocks_[found].count())) {
                found = last;
                place = find(blocks_[last], ball);
            }
        }
        Block& end = blocks_[last];
        blocks_[found].ball[place] = end.ball[static_cast<std::size_t>(--end.tail & 15)];
        if (end.count() == 0 && last != before) {
            blocks_[before].go_on_at(end_of_chain);
            give_back(static_cast<std::int32_t>(last));
        }
    }

    std::int32_t take_block() {
        ++chained_;
        if (free_ != end_of_chain) {
            std::int32_t const block = free_;
            free_ = blocks_[static_cast<std::size_t>(block)].more();
            blocks_[static_cast<std::size_t>(block)] = Block{};
            return block;
        }
        if (blocks_.size() >= blocks_max) throw std::length_error("too many balls for their bins");
        blocks_.emplace_back();
        return static_cast<std::int32_t>(blocks_.size() - 1);
    }

    void give_back(std::int32_t block) {
        --chained_;
        blocks_[static_cast<std::size_t>(block)].go_on_at(free_);
        free_ = block;
    }

    std::int32_t free_ = end_of_chain;
    std::size_t chained_ = 0;
    std::vector<Block> blocks_;
};

} // namespace clack
