#pragma once
// A dataset that grows by rows: the shape of everything that is recorded over time.

#include "io/hdf5.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <vector>

namespace clack::hdf5 {

namespace detail {

/// Rows in one chunk and the chunk's shape. Small rows share a chunk, large ones are split evenly:
/// between 16 KiB, below which the index costs more than the data, and 1 MiB, what HDF5 caches.
std::vector<hsize_t> chunk_shape(std::vector<hsize_t> const& row_shape, std::size_t number_bytes);

Id create_series(Id const& parent, std::string const& name, hid_t type,
                 std::vector<hsize_t> const& row_shape, std::size_t number_bytes);

/// Makes the dataset `rows` long.
void resize_series(Id const& dataset, std::vector<hsize_t> const& row_shape, std::size_t rows);

enum class Transfer { read, write };
void transfer_rows(Id const& dataset, hid_t type, std::vector<hsize_t> const& row_shape,
                   std::size_t first, std::size_t rows, void* numbers, Transfer transfer);

} // namespace detail

/// Rows of numbers in a file. What is pushed waits in memory until `write_waiting`, so that many
/// small rows cost one write.
template <class Number> class Series {
public:
    Series() = default;

    static Series create(Id const& parent, std::string const& name,
                         std::vector<hsize_t> const& row_shape = {}) {
        Series series;
        series.dataset_ =
            detail::create_series(parent, name, native_type<Number>(), row_shape, sizeof(Number));
        series.row_shape_ = row_shape;
        return series;
    }

    static Series open(Id const& parent, std::string const& name) {
        Series series;
        series.dataset_ = open_dataset(parent, name);
        auto const sizes = shape(series.dataset_);
        if (sizes.empty()) throw Error("cannot read dataset " + name + ": it has no rows");
        series.rows_ = static_cast<std::size_t>(sizes.front());
        series.row_shape_.assign(sizes.begin() + 1, sizes.end());
        return series;
    }

    explicit operator bool() const { return static_cast<bool>(dataset_); }
    std::size_t rows() const { return rows_; } // in the file, without those that wait
    std::vector<hsize_t> const& row_shape() const { return row_shape_; }
    std::size_t row_numbers() const {
        return std::accumulate(row_shape_.begin(), row_shape_.end(), std::size_t{1},
                               [](std::size_t product, hsize_t size) {
                                   return product * static_cast<std::size_t>(size);
                               });
    }
    std::size_t waiting_bytes() const { return waiting_.size() * sizeof(Number); }

    void push(Number number) { waiting_.push_back(number); }
    void push(std::span<Number const> numbers) {
        waiting_.insert(waiting_.end(), numbers.begin(), numbers.end());
    }

    /// Appends what waits and hands it to the system, where it outlives this process.
    void write_waiting() {
        if (waiting_.empty()) return;
        append(waiting_);
        waiting_.clear();
    }

    /// The same for rows too large to be copied first. Nothing may wait.
    void write(std::span<Number const> numbers) {
        assert(waiting_.empty());
        append(numbers);
    }

    std::vector<Number> read(std::size_t first, std::size_t rows) const {
        std::vector<Number> numbers(rows * row_numbers());
        read_into(first, rows, numbers.data());
        return numbers;
    }
    void read_into(std::size_t first, std::size_t rows, Number* numbers) const {
        if (first + rows > rows_) throw Error("cannot read past the end of a dataset");
        if (rows == 0) return;
        detail::transfer_rows(dataset_, native_type<Number>(), row_shape_, first, rows, numbers,
                              detail::Transfer::read);
    }

    /// Appends the first `rows` rows of another series, a few megabytes at a time.
    void copy_from(Series const& source, std::size_t rows) {
        constexpr std::size_t batch_bytes = 4u << 20;
        auto const batch =
            std::max<std::size_t>(1, batch_bytes / (source.row_numbers() * sizeof(Number) + 1));
        for (std::size_t first = 0; first < rows; first += batch) {
            push(source.read(first, std::min(batch, rows - first)));
            write_waiting();
        }
    }

private:
    void append(std::span<Number const> numbers) {
        auto const rows = numbers.size() / row_numbers();
        detail::resize_series(dataset_, row_shape_, rows_ + rows);
        detail::transfer_rows(dataset_, native_type<Number>(), row_shape_, rows_, rows,
                              const_cast<Number*>(numbers.data()), detail::Transfer::write);
        checked_status(H5Dflush(dataset_.get()), "flush a dataset");
        rows_ += rows;
    }

    Id dataset_;
    std::vector<hsize_t> row_shape_;
    std::size_t rows_ = 0;
    std::vector<Number> waiting_;
};

} // namespace clack::hdf5
