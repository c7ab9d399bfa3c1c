#include "validation/harness/latex.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace clack::validation {

namespace {

bool is_letter(char const c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

} // namespace

std::string with_error(Estimate const& estimate) {
    if (!(estimate.error > 0)) return fmt::format("{:.6g}", estimate.value);
    int place = static_cast<int>(std::floor(std::log10(estimate.error))) - 1;
    auto digits = std::lround(estimate.error / std::pow(10, place));
    if (digits == 100) { // 0.0999 rounds up to one more place
        digits = 10;
        ++place;
    }
    if (place > 0) {
        double const unit = std::pow(10, place);
        return fmt::format("{:.0f}({:.0f})", std::round(estimate.value / unit) * unit,
                           static_cast<double>(digits) * unit);
    }
    // An error above 1 with digits behind the point is written with its point: 12.3(4.5).
    std::string const error =
        place < 0 && digits >= std::lround(std::pow(10, -place))
            ? fmt::format("{:.{}f}", static_cast<double>(digits) * std::pow(10, place), -place)
            : fmt::format("{}", digits);
    return fmt::format("{:.{}f}({})", estimate.value, -place, error);
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

std::string in_tex(std::string const& text) {
    std::string tex;
    for (char const c : text) {
        switch (c) {
        case '_':
        case '%':
        case '&':
        case '#':
        case '$':
        case '{':
        case '}':
            (tex += '\\') += c;
            break;
        case '<':
        case '>':
        case '|':
            ((tex += '$') += c) += '$';
            break;
        case '^':
            tex += "\\textasciicircum{}";
            break;
        default:
            tex += c;
        }
    }
    return tex;
}

void Macros::define(std::string const& name, std::string const& text) {
    std::string const whole = prefix_ + name;
    if (whole.empty() || !std::all_of(whole.begin(), whole.end(), is_letter)) {
        throw std::invalid_argument(
            fmt::format("macro = {}: TeX's command names are letters only", whole));
    }
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

} // namespace clack::validation
