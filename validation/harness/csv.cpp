#include "validation/harness/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

namespace clack::validation {

std::string cell(double const value) { return fmt::format("{}", value); }

std::string percent(double const part) { return fmt::format("{:.3g} %", 100 * part); }

void Csv::row(std::vector<std::string> cells) {
    if (cells.size() != columns_.size()) {
        throw std::invalid_argument(
            fmt::format("{} cells for {} columns", cells.size(), columns_.size()));
    }
    for (std::string const& text : cells) {
        if (text.find_first_of(",\n") != std::string::npos) {
            throw std::invalid_argument(
                fmt::format("cell = {}: holds a comma or a line end", text));
        }
    }
    rows_.push_back(std::move(cells));
}

std::string Csv::text(std::vector<std::string> const& header) const {
    std::string text;
    for (std::string const& line : header) text += "# " + line + '\n';
    text += fmt::format("{}\n", fmt::join(columns_, ","));
    for (auto const& row : rows_) text += fmt::format("{}\n", fmt::join(row, ","));
    return text;
}

} // namespace clack::validation
