#pragma once
// Which balls are in which cell of a cubic lattice: book-keeping only, no physics.

#include "prediction/lanes.hpp"
#include "state/ball.hpp"
#include "state/chained_bins.hpp"
#include "state/huge_pages.hpp"
#include "state/prefetch.hpp"
#include "state/system.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace clack {

/// A growing list of balls that keeps its memory. Whole blocks are copied into it, so that the copy
/// needs no loop, and the part that counts is kept.
class BallBuffer {
public:
    void clear() { size_ = 0; }
    std::size_t size() const { return size_; }
    std::int32_t const* begin() const { return balls(); }
    std::int32_t const* end() const { return balls() + size_; }

    /// Where the next balls may be written, so many at most; `grow_to` then says where they end.
    [[gnu::always_inline]] std::int32_t* room(std::size_t count) {
        if (size_ + count > in_piece * pieces_.size()) grow(count);
        return pieces_.front().data() + size_;
    }
    void grow_to(std::int32_t const* end) { size_ = static_cast<std::size_t>(end - balls()); }
    void grow_by(std::size_t count) { size_ += count; }

    /// Fills up with one ball to a multiple of `whole`, one at least.
    template <std::size_t whole> void pad(std::int32_t ball) {
        std::fill_n(room(whole), whole, ball);
        size_ = std::max(size_ + whole - 1, whole) / whole * whole;
    }

    std::size_t bytes() const { return pieces_.capacity() * sizeof(Piece); }

private:
    /// So aligned that few blocks are written across the border of two pages of memory: where the
    /// first few always were, cells at packing fraction 0.20 were 0.94 to 0.97 times as fast.
    static constexpr std::size_t in_piece = 128;
    struct alignas(512) Piece : std::array<std::int32_t, in_piece> {};

    std::int32_t const* balls() const { return pieces_.front().data(); }
    [[gnu::noinline, gnu::cold]] void grow(std::size_t count) {
        pieces_.resize(2 * (size_ + count) / in_piece + 1);
    }

    std::vector<Piece> pieces_ = std::vector<Piece>(1);
    std::size_t size_ = 0;
};

/// Three coordinates, and what the owner of the bins notes there.
using Cell = std::array<std::int32_t, 4>;

/// Balls by cell; a bin has a block of `places`. Where there are more cells than bins, cells that
/// are a multiple of the bins apart along an axis share one: a ball's surroundings then hold a few
/// balls that are far away.
template <std::int32_t places> class CellBins {
public:
    CellBins(Boundary boundary, std::int32_t cells_per_side, std::size_t ball_count)
        : boundary_(boundary), bins_per_side_(cells_per_side),
          cell_of_(large_vector<Cell>(ball_count)) {
        lay_out(cells_per_side);
        clear();
    }

    /// Cuts the cube into more cells, a multiple of the bins, or into as many again.
    void lay_out(std::int32_t cells_per_side) {
        per_side_ = cells_per_side;
        auto const m = static_cast<std::size_t>(bins_per_side_);
        auto const c = static_cast<std::size_t>(per_side_);
        // Beyond walls lies one layer of bins that stay empty.
        std::size_t const beyond = boundary_ == Boundary::walls ? 1 : 0;
        std::size_t stride = 1;
        for (auto& line : line_) {
            line.clear();
            line.push_back((beyond ? 0 : (c - 1) % m) * stride);
            for (std::size_t k = 0; k < c; ++k) line.push_back((k % m + beyond) * stride);
            line.push_back((beyond ? m + 1 : 0) * stride);
            stride *= m + 2 * beyond;
        }
        bin_count_ = stride;
    }

    std::int32_t cells_per_side() const { return per_side_; }
    Cell const& cell_of(std::int32_t ball) const {
        return cell_of_[static_cast<std::size_t>(ball)];
    }

    void note(std::int32_t ball, std::int32_t something) {
        cell_of_[static_cast<std::size_t>(ball)][3] = something;
    }
    std::size_t ball_count() const { return cell_of_.size(); }

    /// The coordinates; the fourth number is the note.
    Fours<double> cell_as_four(std::int32_t ball) const {
        using Integers [[gnu::vector_size(16)]] = std::int32_t;
        Integers loaded;
        std::memcpy(&loaded, &cell_of(ball), sizeof loaded);
        return __builtin_convertvector(loaded, Fours<double>);
    }

    void clear() { cells_.reset(bin_count_); }

    void insert(std::int32_t ball, Cell const& cell) {
        cell_of_[static_cast<std::size_t>(ball)] = cell;
        cells_.insert(index(cell), ball);
    }

    void remove(std::int32_t ball) { cells_.remove(index(cell_of(ball)), ball); }

    /// Appends the balls of a cell and of the 26 around it.
    void collect_around(Cell const& cell, BallBuffer& balls) const {
        if (lies_in_row(cell)) {
            collect<RowGatherer<places>>(balls, 27,
                                         [&](auto&& append) { for_each_row_around(cell, append); });
        } else {
            collect<BlockGatherer<places>>(balls, 27,
                                           [&](auto&& append) { for_each_around(cell, append); });
        }
    }

    /// Appends the balls of the nine cells beyond one face of a cell's surroundings.
    void collect_beyond(Cell const& cell, std::size_t axis, std::int32_t direction,
                        BallBuffer& balls) const {
        if (axis != 0 && lies_in_row(cell)) {
            collect<RowGatherer<places>>(balls, 9, [&](auto&& append) {
                for_each_row_beyond(cell, axis, direction, append);
            });
        } else {
            collect<BlockGatherer<places>>(
                balls, 9, [&](auto&& append) { for_each_beyond(cell, axis, direction, append); });
        }
    }

    /// Hints to the memory: where a ball is, and what `remove`, the two above, and `insert` into
    /// the cell that a face lies before will read.
    void fetch(std::int32_t ball) const { prefetch(cell_of_.data() + ball); }
    void fetch_own(std::int32_t ball) const { fetch_bin(index(cell_of(ball))); }
    void fetch_around(Cell const& cell) const {
        for_each_around(cell, [&](std::size_t bin) { fetch_bin(bin); });
    }
    void fetch_beyond(Cell const& cell, std::size_t axis, std::int32_t direction) const {
        for_each_beyond(cell, axis, direction, [&](std::size_t bin) { fetch_bin(bin); });
        fetch_bin(index(cell));
    }

    /// The next cell along an axis, through the boundary where it is periodic.
    std::int32_t next(std::int32_t coordinate, std::int32_t direction) const {
        std::int32_t const there = coordinate + direction;
        return there < 0 ? per_side_ - 1 : there == per_side_ ? 0 : there;
    }

    std::size_t bytes() const { return cells_.bytes() + cell_of_.capacity() * sizeof(Cell); }

private:
    using Cells = ChainedBins<places>;
    using Block = typename Cells::Block;

    void fetch_bin(std::size_t bin) const { prefetch(&cells_.block(bin)); }
    /// Calls visit(bin) for a cell and the 26 around it.
    template <class Visit>
    [[gnu::always_inline]] void for_each_around(Cell const& cell, Visit&& visit) const {
        auto const x = lines(0, cell), y = lines(1, cell);
        for (std::size_t const in_z : lines(2, cell)) {
            for (std::size_t const in_y : y) {
                std::size_t const row = in_z + in_y;
                visit(row + x[0]);
                visit(row + x[1]);
                visit(row + x[2]);
            }
        }
    }

    /// Calls visit(bin) for the nine cells beyond one face of a cell's surroundings.
    template <class Visit>
    [[gnu::always_inline]] void for_each_beyond(Cell const& cell, std::size_t axis,
                                                std::int32_t direction, Visit&& visit) const {
        std::size_t const face = lines(axis, cell)[direction < 0 ? 0 : 2];
        auto const u = lines((axis + 1) % 3, cell), v = lines((axis + 2) % 3, cell);
        for (std::size_t const in_u : u) {
            std::size_t const row = face + in_u;
            visit(row + v[0]);
            visit(row + v[1]);
            visit(row + v[2]);
        }
    }

    /// Whether the bins before and behind a cell's along the first axis lie beside it in memory.
    bool lies_in_row(Cell const& cell) const {
        auto const x = lines(0, cell);
        return x[2] == x[0] + 2;
    }

    /// Calls visit(bin) for the first bin of each row of three of a cell and the 26 around it.
    template <class Visit>
    [[gnu::always_inline]] void for_each_row_around(Cell const& cell, Visit&& visit) const {
        std::size_t const x = lines(0, cell)[0];
        auto const y = lines(1, cell);
        for (std::size_t const in_z : lines(2, cell))
            for (std::size_t const in_y : y) visit(in_z + in_y + x);
    }

    /// And of the nine cells beyond one face across the second or third axis.
    template <class Visit>
    [[gnu::always_inline]] void for_each_row_beyond(Cell const& cell, std::size_t axis,
                                                    std::int32_t direction, Visit&& visit) const {
        std::size_t const face = lines(axis, cell)[direction < 0 ? 0 : 2] + lines(0, cell)[0];
        for (std::size_t const in_u : lines(3 - axis, cell)) visit(face + in_u);
    }

    /// Appends the balls of so many bins: `visit` calls what it is given for each of them or, if
    /// rows are gathered, for the first of three. Measured at packing fraction 0.05 against a loop
    /// over each bin: a seventh of all instructions saved.
    template <class Gatherer, class Visit>
    [[gnu::always_inline]] void collect(BallBuffer& balls, std::size_t bins, Visit&& visit) const {
        Gatherer gatherer(balls.room(bins * (places + 1) + 16));
        Block const* const blocks = &cells_.block(0);
        visit([&](std::size_t bin) { gatherer.add(blocks[bin].ball.data()); });
        balls.grow_to(gatherer.end());
        if (!gatherer.any_chain()) return;
        visit([&](std::size_t bin) {
            constexpr bool rows = std::is_same_v<Gatherer, RowGatherer<places>>;
            for (std::size_t k = 0; k < (rows ? 3 : 1); ++k) collect_chain(bin + k, balls);
        });
    }

    /// What does not fit into a bin's first block.
    void collect_chain(std::size_t bin, BallBuffer& balls) const {
        for (std::int32_t more = cells_.block(bin).more(); more != Cells::end_of_chain;) {
            Block const& block = cells_.block(static_cast<std::size_t>(more));
            std::copy_n(block.ball.data(), block.count(), balls.room(block.ball.size()));
            balls.grow_by(static_cast<std::size_t>(block.count()));
            more = block.more();
        }
    }

    /// What the coordinates one less, the same and one more along an axis add to a cell's index.
    std::array<std::size_t, 3> lines(std::size_t axis, Cell const& cell) const {
        std::size_t const* const line = line_[axis].data() + static_cast<std::size_t>(cell[axis]);
        return {line[0], line[1], line[2]};
    }
    std::size_t index(Cell const& cell) const {
        return lines(0, cell)[1] + lines(1, cell)[1] + lines(2, cell)[1];
    }

    Boundary boundary_;
    std::int32_t bins_per_side_, per_side_ = 0;
    Cells cells_;
    std::vector<Cell> cell_of_;
    std::array<std::vector<std::size_t>, 3> line_; // of the coordinates from -1 to per_side_
    std::size_t bin_count_ = 0;
};

} // namespace clack
