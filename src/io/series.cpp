#include "io/series.hpp"

namespace clack::hdf5::detail {

namespace {

constexpr std::size_t chunk_bytes_min = 16u << 10;
constexpr std::size_t chunk_bytes_max = 1u << 20;

std::vector<hsize_t> with_rows(hsize_t rows, std::vector<hsize_t> const& row_shape) {
    std::vector<hsize_t> whole{rows};
    whole.insert(whole.end(), row_shape.begin(), row_shape.end());
    return whole;
}

} // namespace

std::vector<hsize_t> chunk_shape(std::vector<hsize_t> const& row_shape, std::size_t number_bytes) {
    std::size_t row_bytes = number_bytes;
    for (auto const size : row_shape) row_bytes *= static_cast<std::size_t>(size);
    auto chunk = with_rows(1, row_shape);
    if (row_bytes < chunk_bytes_min) {
        chunk[0] = chunk_bytes_min / std::max<std::size_t>(row_bytes, 1);
    } else if (row_bytes > chunk_bytes_max) {
        auto const pieces = (row_bytes + chunk_bytes_max - 1) / chunk_bytes_max;
        chunk[1] = (chunk[1] + pieces - 1) / pieces;
    }
    return chunk;
}

Id create_series(Id const& parent, std::string const& name, hid_t type,
                 std::vector<hsize_t> const& row_shape, std::size_t number_bytes) {
    auto const start = with_rows(0, row_shape);
    auto limit = start;
    limit[0] = H5S_UNLIMITED;
    auto const chunk = chunk_shape(row_shape, number_bytes);
    auto const rank = static_cast<int>(start.size());
    Id const space(checked(H5Screate_simple(rank, start.data(), limit.data()), "make a dataspace"),
                   H5Sclose);
    Id const list(checked(H5Pcreate(H5P_DATASET_CREATE), "prepare dataset " + name), H5Pclose);
    checked_status(H5Pset_chunk(list.get(), rank, chunk.data()), "prepare dataset " + name);
    // Without times of change an append touches nothing but the data and their index.
    checked_status(H5Pset_obj_track_times(list.get(), false), "prepare dataset " + name);
    return {checked(H5Dcreate2(parent.get(), name.c_str(), type, space.get(), H5P_DEFAULT,
                               list.get(), H5P_DEFAULT),
                    "create dataset " + name),
            H5Dclose};
}

void resize_series(Id const& dataset, std::vector<hsize_t> const& row_shape, std::size_t rows) {
    auto const whole = with_rows(rows, row_shape);
    checked_status(H5Dset_extent(dataset.get(), whole.data()), "extend a dataset");
}

void transfer_rows(Id const& dataset, hid_t type, std::vector<hsize_t> const& row_shape,
                   std::size_t first, std::size_t rows, void* numbers, Transfer transfer) {
    auto const block = with_rows(rows, row_shape);
    std::vector<hsize_t> start(block.size(), 0);
    start[0] = first;
    Id const file_space(checked(H5Dget_space(dataset.get()), "select rows"), H5Sclose);
    checked_status(H5Sselect_hyperslab(file_space.get(), H5S_SELECT_SET, start.data(), nullptr,
                                       block.data(), nullptr),
                   "select rows");
    Id const memory_space(
        checked(H5Screate_simple(static_cast<int>(block.size()), block.data(), nullptr),
                "select rows"),
        H5Sclose);
    if (transfer == Transfer::write) {
        checked_status(H5Dwrite(dataset.get(), type, memory_space.get(), file_space.get(),
                                H5P_DEFAULT, numbers),
                       "append to a dataset");
    } else {
        checked_status(H5Dread(dataset.get(), type, memory_space.get(), file_space.get(),
                               H5P_DEFAULT, numbers),
                       "read a dataset");
    }
}

} // namespace clack::hdf5::detail
