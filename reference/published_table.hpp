#pragma once
// The tables in reference/*.csv: numbers in named columns under comment lines that say where they
// come from.

#include <filesystem>
#include <string>
#include <vector>

namespace clack::reference {

/// A table of numbers read from a CSV file with `#` comment lines and one line of column names.
class PublishedTable {
public:
    /// Throws std::runtime_error, naming file and line, for what cannot be read or is no number.
    explicit PublishedTable(std::filesystem::path const& path);

    /// One of the tables that stand beside this file, by its file name.
    static PublishedTable of_reference(std::string const& file_name);

    std::size_t row_count() const { return row_count_; }
    /// Throws std::out_of_range for a name that the table does not have.
    std::vector<double> const& column(std::string const& name) const;
    /// The comment lines: the provenance.
    std::vector<std::string> const& comments() const { return comments_; }

private:
    std::vector<std::string> comments_, names_;
    std::vector<std::vector<double>> columns_;
    std::size_t row_count_ = 0;
};

} // namespace clack::reference
