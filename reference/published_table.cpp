#include "reference/published_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace clack::reference {

namespace {

std::vector<std::string> cells_of(std::string const& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

} // namespace

PublishedTable::PublishedTable(std::filesystem::path const& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(fmt::format("{}: cannot be read", path.string()));
    int line_number = 0;
    for (std::string line; std::getline(file, line);) {
        ++line_number;
        if (line.starts_with('#')) {
            comments_.push_back(line);
            continue;
        }
        std::vector<std::string> const cells = cells_of(line);
        if (names_.empty()) {
            names_ = cells;
            columns_.resize(names_.size());
            continue;
        }
        if (cells.size() != names_.size()) {
            throw std::runtime_error(fmt::format("{}:{}: {} cells under {} columns", path.string(),
                                                 line_number, cells.size(), names_.size()));
        }
        for (std::size_t k = 0; k < cells.size(); ++k) {
            try {
                columns_[k].push_back(std::stod(cells[k]));
            } catch (std::logic_error const&) {
                throw std::runtime_error(fmt::format("{}:{}: {} = {}: not a number", path.string(),
                                                     line_number, names_[k], cells[k]));
            }
        }
        ++row_count_;
    }
}

PublishedTable PublishedTable::of_reference(std::string const& file_name) {
    return PublishedTable(std::filesystem::path(CLACK_REFERENCE_DIR) / file_name);
}

std::vector<double> const& PublishedTable::column(std::string const& name) const {
    auto const found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end())
        throw std::out_of_range(fmt::format("no column {} in the table", name));
    return columns_[static_cast<std::size_t>(found - names_.begin())];
}

} // namespace clack::reference
