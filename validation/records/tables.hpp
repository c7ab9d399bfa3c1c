#pragma once
// Results as text: cells, files of columns for gnuplot, tables and macros for the report.

#include "validation/statistics/estimate.hpp"

#include <concepts>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace clack::validation {

/// One cell: a number with all its digits, or a word.
std::string cell(double value);
std::string cell(std::integral auto value) { return std::to_string(value); }
inline std::string cell(std::string word) { return word; }

/// Cells in a row, of numbers, words, Estimates, which are two, value and error, and rows.
template <class... Parts> std::vector<std::string> cells(Parts const&... parts) {
    std::vector<std::string> all;
    auto const add = [&]<class Part>(Part const& part) {
        if constexpr (std::same_as<Part, Estimate>)
            all.insert(all.end(), {cell(part.value), cell(part.error)});
        else if constexpr (std::same_as<Part, std::vector<std::string>>)
            all.insert(all.end(), part.begin(), part.end());
        else
            all.push_back(cell(part));
    };
    (add(parts), ...);
    return all;
}

/// A part of something, in per cent: "0.2 %".
std::string percent(double part);

/// A value with its standard error in its last digits: 3.2694(12). The error keeps two digits; an
/// error of 0 leaves six digits and no bracket.
std::string with_error(Estimate const& estimate);

/// With so many significant digits; beyond 1e4 or below 1e-3 as a power of ten, in math mode:
/// $1.3 \times 10^{-5}$.
std::string significant(double value, int digits);

/// Plain text as TeX takes it: the characters that mean something there are escaped, and those that
/// its text fonts lack are set as mathematics.
std::string in_tex(std::string_view text);

/// Rows under named columns. A column's name ends in its unit where it has one.
class Csv {
public:
    explicit Csv(std::vector<std::string> columns) : columns_(std::move(columns)) {}

    /// Adds a row. Throws std::invalid_argument unless it has a cell for each column, without
    /// commas.
    void row(std::vector<std::string> row);
    template <class... Parts>
    requires(sizeof...(Parts) > 1) void row(Parts const&... parts) { row(cells(parts...)); }

    /// The file's text: `header` lines behind `# `, the names, the rows.
    std::string text(std::vector<std::string> const& header) const;

private:
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
};

/// \newcommand macros, one a number that the report quotes.
class Macros {
public:
    ///   prefix   the experiment's name in CamelCase; every macro starts with it
    explicit Macros(std::string prefix) : prefix_(std::move(prefix)) {}

    /// Defines \<prefix><name>. Throws std::invalid_argument unless prefix and name are letters
    /// only, as TeX wants them, and the name is new.
    void define(std::string const& name, std::string const& text);

    std::string text(std::vector<std::string> const& header) const;

private:
    std::string prefix_;
    std::vector<std::pair<std::string, std::string>> macros_;
};

/// A booktabs tabular.
///   alignment   TeX's column specification, such as "rrl"
///   head        column titles
std::string tabular(std::string const& alignment, std::vector<std::string> const& head,
                    std::vector<std::vector<std::string>> const& rows);

/// Writes a file under a temporary name and moves it into place, so that whoever sees it sees all
/// of it. Throws InputError when it cannot be written.
void write_file(std::filesystem::path const& path, std::string_view text);

} // namespace clack::validation
