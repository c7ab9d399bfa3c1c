#include "validation/records/tables.hpp"

#include "state/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace clack::validation {

std::string cell(double const value) { return fmt::format("{}", value); }

std::string percent(double const part) { return fmt::format("{:.3g} %", 100 * part); }

std::string with_error(Estimate const& estimate) {
    if (!std::isnormal(estimate.error)) return fmt::format("{:.6g}", estimate.value);
    std::string const error = fmt::format("{:.1e}", estimate.error); // 1.2e-03
    int const power = std::stoi(error.substr(4));
    if (power > 0) {
        double const unit = std::pow(10, power - 1);
        return fmt::format("{:.0f}({:.0f})", std::round(estimate.value / unit) * unit,
                           std::stod(error));
    }
    // An error above 1 is written with its point: 12.3(4.5).
    return fmt::format("{:.{}f}({})", estimate.value, 1 - power,
                       power == 0 ? error.substr(0, 3) : std::string{error[0], error[2]});
}

std::string significant(double const value, int const digits) {
    std::string const scientific = fmt::format("{:.{}e}", value, digits - 1);
    std::size_t const mark = scientific.find('e');
    if (value == 0 || mark == std::string::npos) return fmt::format("{}", value);
    int const power = std::stoi(scientific.substr(mark + 1));
    if (power < -3 || power >= 4)
        return fmt::format("${} \\times 10^{{{}}}$", scientific.substr(0, mark), power);
    return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - power));
}

std::string in_tex(std::string_view const text) {
    constexpr std::string_view commands = "_%&#${}", only_in_formulas = "<>|";
    std::string tex;
    for (char const c : text) {
        if (commands.find(c) != std::string_view::npos)
            tex += fmt::format("\\{}", c);
        else if (only_in_formulas.find(c) != std::string_view::npos)
            tex += fmt::format("${}$", c);
        else
            tex += c == '^' ? "\\textasciicircum{}" : std::string(1, c);
    }
    return tex;
}

void Csv::row(std::vector<std::string> row) {
    if (row.size() != columns_.size())
        throw std::invalid_argument(fmt::format("{} cells for the {} columns {}", row.size(),
                                                columns_.size(), fmt::join(columns_, ", ")));
    for (std::string const& text : row)
        if (text.find_first_of(",\n") != std::string::npos)
            throw std::invalid_argument(
                fmt::format("cell = {}: holds a comma or a line end", text));
    rows_.push_back(std::move(row));
}

std::string Csv::text(std::vector<std::string> const& header) const {
    std::string text;
    for (std::string const& line : header) text += "# " + line + '\n';
    text += fmt::format("{}\n", fmt::join(columns_, ","));
    for (auto const& row : rows_) text += fmt::format("{}\n", fmt::join(row, ","));
    return text;
}

void Macros::define(std::string const& name, std::string const& text) {
    std::string const whole = prefix_ + name;
    for (char const c : whole)
        if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')))
            throw std::invalid_argument(
                fmt::format("macro = {}: TeX's command names are letters only", whole));
    for (auto const& [known, meaning] : macros_)
        if (known == whole) throw std::invalid_argument(fmt::format("macro = {}: twice", whole));
    macros_.emplace_back(whole, text);
}

std::string Macros::text(std::vector<std::string> const& header) const {
    std::string text;
    for (std::string const& line : header) text += "% " + line + '\n';
    for (auto const& [name, meaning] : macros_)
        text += fmt::format("\\newcommand{{\\{}}}{{{}}}\n", name, meaning);
    return text;
}

std::string tabular(std::string const& alignment, std::vector<std::string> const& head,
                    std::vector<std::vector<std::string>> const& rows) {
    std::string text = fmt::format("\\begin{{tabular}}{{{}}}\n\\toprule\n{} \\\\\n\\midrule\n",
                                   alignment, fmt::join(head, " & "));
    for (auto const& row : rows) text += fmt::format("{} \\\\\n", fmt::join(row, " & "));
    return text + "\\bottomrule\n\\end{tabular}\n";
}

void write_file(std::filesystem::path const& path, std::string_view const text) {
    std::filesystem::path temporary = path;
    temporary += ".part";
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file << text;
    file.close();
    if (!file) throw InputError(fmt::format("{}: cannot be written", path.string()));
    std::filesystem::rename(temporary, path);
}

} // namespace clack::validation
