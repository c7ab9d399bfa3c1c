#pragma once
// The failure atlas as the report shows it: a table of thresholds, and ties in words.

#include "validation/atlas_rows.hpp"
#include "validation/records/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

namespace clack::validation::atlas {

/// The letters of figure and table: what becomes of a method, and why a place is empty.
inline char letter_of(Kind const kind) { return "-DOVELHC"[static_cast<std::size_t>(kind)]; }
inline char letter_of(Absence const absence) { return " twrm"[static_cast<std::size_t>(absence)]; }

/// All rows and columns, and what was found.
struct Atlas {
    std::vector<Scene> scenes;
    std::vector<Contender> contenders;
    std::vector<Row> rows;

    std::size_t column(std::string const& name) const {
        return static_cast<std::size_t>(std::ranges::find(contenders, name, &Contender::name) -
                                        contenders.begin());
    }
    std::ptrdiff_t failures(std::string const& name) const { // in so many rows
        return std::ranges::count_if(
            rows, [&](Row const& row) { return row.cells[column(name)].fails(); });
    }
};

/// From where on a method fails and the worst that becomes of it, or why it was not run.
inline std::string in_short(Cell const& found) {
    if (found.worst == Kind::ok) return "--";
    if (!found.fails()) return {letter_of(found.absence)};
    return fmt::format("{:.3g}\\,{}", is_gross(found.worst) ? found.gross : found.threshold,
                       letter_of(found.worst));
}

/// All but the slower of clack's own; LAMMPS by its stiffness, a rule by its first word.
inline std::string table_of(Atlas const& atlas) {
    std::vector<std::string> head{"scene"};
    std::vector<std::vector<std::string>> rows;
    for (Scene const& scene : atlas.scenes) rows.push_back({scene.name});
    for (std::size_t c = atlas.column("fast float"); c < atlas.contenders.size(); ++c) {
        std::string const& name = atlas.contenders[c].name;
        std::string const first = name.substr(0, name.find(' ')), rest = name.substr(first.size());
        if (first == "table" || first == "heap") continue;
        head.push_back(first == "fast" ? rest : first == "LAMMPS" ? "$" + rest + "$" : first);
        for (std::size_t r = 0; r < rows.size(); ++r)
            rows[r].push_back(in_short(atlas.rows[r].cells[c]));
    }
    return tabular(std::string(head.size(), 'l'), head, rows);
}

/// The scenes in which physics has no answer, and whom the tie rule lets meet.
inline std::string ties_of(Atlas const& atlas) {
    std::vector<std::string> ties;
    for (std::size_t r = 0; r < atlas.rows.size(); ++r) {
        if (!(atlas.rows[r].no_limit_from >= atlas.scenes[r].levels.front())) continue;
        std::vector<std::string> meetings;
        for (auto const& [i, j] : atlas.rows[r].tie)
            meetings.push_back(fmt::format("{}--{}", i, j));
        ties.push_back(fmt::format("{} ({})", atlas.scenes[r].name, fmt::join(meetings, ", ")));
    }
    return ties.empty() ? "none" : fmt::format("{}", fmt::join(ties, "; "));
}

} // namespace clack::validation::atlas
