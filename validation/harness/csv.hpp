#pragma once
// A table of results as a file that people, gnuplot and spreadsheets read.

#include <concepts>
#include <string>
#include <vector>

namespace clack::validation {

/// One cell: a number with all its digits, or a word.
std::string cell(double value);
std::string cell(std::integral auto value) { return std::to_string(value); }
inline std::string cell(std::string word) { return word; }

/// A part of something, in per cent: "0.2 %".
std::string percent(double part);

/// Rows under named columns. A column's name ends in its unit where it has one.
class Csv {
public:
    explicit Csv(std::vector<std::string> columns) : columns_(std::move(columns)) {}

    /// Adds a row. Throws std::invalid_argument unless it has a cell for each column, without
    /// commas.
    void row(std::vector<std::string> cells);

    /// The file's text: `header` lines behind `# `, the names, the rows.
    std::string text(std::vector<std::string> const& header) const;

private:
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
};

} // namespace clack::validation
