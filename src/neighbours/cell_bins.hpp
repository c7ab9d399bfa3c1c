#pragma once
// Which balls are in which cell of a cubic lattice: book-keeping only, no physics.

#include "state/system.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace clack {

/// A growing list of balls that keeps its memory. Whole blocks are copied into it, so that the copy
/// needs no loop, and the part that counts is kept.
class BallBuffer {
public:
    void clear() { size_ = 0; }
    std::size_t size() const { return size_; }
    std::int32_t const* begin() const { return balls_.data(); }
    std::int32_t const* end() const { return balls_.data() + size_; }

    template <std::size_t places>
    void append(std::array<std::int32_t, places> const& block, std::int32_t count) {
        if (size_ + places > balls_.size()) balls_.resize(2 * balls_.size() + places);
        std::copy_n(block.begin(), places, balls_.data() + size_);
        size_ += static_cast<std::size_t>(count);
    }

    std::size_t bytes() const { return balls_.capacity() * sizeof(std::int32_t); }

private:
    std::vector<std::int32_t> balls_;
    std::size_t size_ = 0;
};

/// Balls by cell. A cell is a block of six places and, when it is full, a chain of further blocks
/// from a pool: nothing can overflow.
class CellBins {
public:
    using Cell = std::array<std::int32_t, 3>;

    CellBins(Boundary boundary, std::int32_t cells_per_side, std::size_t ball_count)
        : boundary_(boundary), per_side_(cells_per_side), cell_of_(ball_count) {
        clear();
    }

    std::int32_t cells_per_side() const { return per_side_; }
    Cell const& cell_of(std::int32_t ball) const {
        return cell_of_[static_cast<std::size_t>(ball)];
    }

    void clear() {
        auto const m = static_cast<std::size_t>(per_side_);
        blocks_.assign(m * m * m, Block{});
        free_ = end_of_chain;
    }

    void insert(std::int32_t ball, Cell const& cell) {
        cell_of_[static_cast<std::size_t>(ball)] = cell;
        std::size_t block = index(cell);
        while (blocks_[block].count == places) {
            if (blocks_[block].more == end_of_chain) {
                std::int32_t const fresh = take_block();
                blocks_[block].more = fresh;
            }
            block = static_cast<std::size_t>(blocks_[block].more);
        }
        Block& room = blocks_[block];
        room.ball[static_cast<std::size_t>(room.count++)] = ball;
    }

    void remove(std::int32_t ball) {
        std::size_t last = index(cell_of(ball)), before = last, found = last;
        std::size_t place = blocks_[last].find(ball);
        while (blocks_[last].more != end_of_chain) {
            before = last;
            last = static_cast<std::size_t>(blocks_[last].more);
            if (place == static_cast<std::size_t>(blocks_[found].count)) {
                found = last;
                place = blocks_[last].find(ball);
            }
        }
        // The last ball of the chain takes the place that becomes free.
        Block& tail = blocks_[last];
        blocks_[found].ball[place] = tail.ball[static_cast<std::size_t>(--tail.count)];
        if (tail.count == 0 && last != before) release_block(before, last);
    }

    /// Appends the balls of the cells in a block of the lattice: along each axis the given offsets
    /// from `centre`, through the boundary where it is periodic.
    void collect_block(Cell const& centre, Cell const& from, Cell const& to,
                       BallBuffer& balls) const {
        for (std::int32_t dz = from[2]; dz <= to[2]; ++dz) {
            std::int32_t x = 0, y = 0, z = 0;
            if (!neighbour(centre[2], dz, z)) continue;
            for (std::int32_t dy = from[1]; dy <= to[1]; ++dy) {
                if (!neighbour(centre[1], dy, y)) continue;
                std::size_t const row = index({0, y, z});
                for (std::int32_t dx = from[0]; dx <= to[0]; ++dx) {
                    if (neighbour(centre[0], dx, x))
                        collect(row + static_cast<std::size_t>(x), balls);
                }
            }
        }
    }

    /// The coordinate `offset` cells further; false beyond a wall.
    bool neighbour(std::int32_t coordinate, std::int32_t offset, std::int32_t& result) const {
        result = coordinate + offset;
        if (result >= 0 && result < per_side_) return true;
        if (boundary_ == Boundary::walls) return false;
        result += result < 0 ? per_side_ : -per_side_;
        return true;
    }

    std::size_t bytes() const {
        return blocks_.capacity() * sizeof(Block) + cell_of_.capacity() * sizeof(Cell);
    }

private:
    static constexpr std::int32_t places = 6; // a block is half a cache line
    static constexpr std::int32_t end_of_chain = -1;

    struct Block {
        std::int32_t count = 0;
        std::int32_t more = end_of_chain;
        std::array<std::int32_t, places> ball{};

        std::size_t find(std::int32_t wanted) const {
            std::size_t place = 0;
            while (place < static_cast<std::size_t>(count) && ball[place] != wanted) ++place;
            return place;
        }
    };

    void collect(std::size_t block, BallBuffer& balls) const {
        for (;; block = static_cast<std::size_t>(blocks_[block].more)) {
            Block const& here = blocks_[block];
            balls.append(here.ball, here.count);
            if (here.more == end_of_chain) return;
        }
    }

    std::size_t index(Cell const& cell) const {
        auto const m = static_cast<std::size_t>(per_side_);
        return (static_cast<std::size_t>(cell[2]) * m + static_cast<std::size_t>(cell[1])) * m +
               static_cast<std::size_t>(cell[0]);
    }

    std::int32_t take_block() {
        if (free_ != end_of_chain) {
            std::int32_t const block = free_;
            free_ = blocks_[static_cast<std::size_t>(block)].more;
            blocks_[static_cast<std::size_t>(block)] = Block{};
            return block;
        }
        blocks_.emplace_back();
        return static_cast<std::int32_t>(blocks_.size() - 1);
    }

    void release_block(std::size_t before, std::size_t block) {
        blocks_[before].more = end_of_chain;
        blocks_[block].more = free_;
        free_ = static_cast<std::int32_t>(block);
    }

    Boundary boundary_;
    std::int32_t per_side_;
    std::int32_t free_ = end_of_chain;
    std::vector<Block> blocks_;
    std::vector<Cell> cell_of_;
};

} // namespace clack
