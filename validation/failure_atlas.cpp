// In which scenes do methods fail, which of them, and from where on?

#include "validation/atlas_rows.hpp"
#include "validation/harness/experiment.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

namespace clack::validation {

using namespace atlas;

Question const question{
    "failure_atlas",
    "Is the fast method right to rounding in every scene that makes methods fail, and does each "
    "rule of the textbooks fail in one of them?",
    fmt::format(
        "{} times what rounding the start does to the scene's own answer and a rounding for "
        "each collision",
        allowance),
    "the answer is of quad precision or closed form; overlaps and the energy are held to the same, "
    "where physics has no answer"};

namespace {

char const* name_of(Kind const kind) {
    constexpr std::array names{"ok",      "loses digits", "wrong order",
                               "overlap", "energy drift", "lost ball",
                               "hang",    "crash",        "not run"};
    return names.at(static_cast<std::size_t>(kind));
}

/// Why a place is empty: the letters of figure and table.
char const* letter_of(Absence const absence) {
    constexpr std::array letters{"", "t", "w", "p", "r", "m"};
    return letters.at(static_cast<std::size_t>(absence));
}

struct Atlas {
    std::vector<Scene> scenes;
    std::vector<Contender> contenders;
    std::vector<Row> rows;

    std::size_t column(std::string const& name) const {
        std::size_t column = 0;
        while (contenders.at(column).name != name) ++column;
        return column;
    }
    /// In how many rows a column fails.
    std::ptrdiff_t failures(std::size_t column) const {
        return std::count_if(rows.begin(), rows.end(), [&](Row const& row) {
            Kind const worst = row.cells[column].worst;
            return worst != Kind::ok && worst != Kind::not_run;
        });
    }
    bool champion_stands() const {
        return std::all_of(rows.begin(), rows.end(), [&](Row const& row) {
            return row.cells[column(champion)].worst == Kind::ok;
        });
    }
    bool has_power() const {
        for (std::size_t c = 0; c < contenders.size(); ++c)
            if (contenders[c].family == Contender::Family::textbook && failures(c) == 0)
                return false;
        return true;
    }
};

Csv csv_of(Atlas const& atlas) {
    Csv csv({"row", "scene", "parameter", "column", "method", "outcome", "outcome_code",
             "digits_lost", "threshold_k", "first_k", "last_k", "no_limit_from_k", "gross_from_k",
             "reached_k", "why_not", "collisions", "energy_drift", "deepest_overlap"});
    for (std::size_t r = 0; r < atlas.rows.size(); ++r) {
        Scene const& scene = atlas.scenes[r];
        for (std::size_t c = 0; c < atlas.contenders.size(); ++c) {
            Cell const& found = atlas.rows[r].cells[c];
            csv.row({cell(r), scene.name, scene.parameter, cell(c), atlas.contenders[c].name,
                     name_of(found.worst), cell(static_cast<int>(found.worst)), cell(found.digits),
                     cell(found.threshold), cell(scene.levels.front()), cell(scene.levels.back()),
                     cell(atlas.rows[r].no_limit_from), cell(found.gross), cell(found.reached),
                     letter_of(found.absence), cell(found.extent.collisions),
                     cell(found.extent.energy_drift), cell(found.extent.deepest_overlap)});
        }
    }
    return csv;
}

/// Where a column begins to fail and where to lose more than digits, and the worst that becomes of
/// it; how far it was run, where not to the end.
std::string in_short(Cell const& found, double const last) {
    constexpr std::array letters{"", "D", "O", "V", "E", "L", "H", "C"};
    if (found.worst == Kind::not_run) return letter_of(found.absence);
    if (found.worst == Kind::ok)
        return found.reached < last ? fmt::format("-- to {:.3g}", found.reached) : "--";
    bool const first_digits = is_gross(found.worst) && found.threshold < found.gross;
    return (first_digits ? fmt::format("{:.3g}\\,D, ", found.threshold) : "") +
           fmt::format("{:.3g}\\,{}", is_gross(found.worst) ? found.gross : found.threshold,
                       letters.at(static_cast<std::size_t>(found.worst)));
}

std::string table_of(Atlas const& atlas) {
    std::vector<std::string> head{"scene", "$k$", "float", "double"};
    std::vector<std::size_t> columns{atlas.column("fast float"), atlas.column(champion)};
    for (std::size_t c = atlas.column("frames"); c < atlas.contenders.size(); ++c) {
        columns.push_back(c);
        std::string const& name = atlas.contenders[c].name;
        auto const space = name.find(' ');
        // LAMMPS by its stiffness, a rule by its first word.
        head.push_back(name.starts_with("LAMMPS") ? '$' + name.substr(space + 1) + '$'
                                                  : name.substr(0, space));
    }
    std::vector<std::vector<std::string>> rows;
    for (std::size_t r = 0; r < atlas.rows.size(); ++r) {
        Scene const& scene = atlas.scenes[r];
        bool const limited = atlas.rows[r].no_limit_from >= scene.levels.front();
        std::vector<std::string> cells{
            scene.name + (limited ? "$^\\dagger$" : ""),
            fmt::format("{:g} \\dots {:g}", scene.levels.front(), scene.levels.back())};
        for (std::size_t const c : columns)
            cells.push_back(in_short(atlas.rows[r].cells[c], scene.levels.back()));
        rows.push_back(cells);
    }
    return tabular("ll" + std::string(columns.size(), 'l'), head, rows);
}

/// The scenes in which physics has no answer, and whom the tie rule lets meet.
std::string ties_of(Atlas const& atlas) {
    std::string text;
    for (std::size_t r = 0; r < atlas.rows.size(); ++r) {
        Row const& row = atlas.rows[r];
        if (!(row.no_limit_from >= atlas.scenes[r].levels.front())) continue;
        std::string order;
        for (auto const& [i, j] : row.tie)
            order += fmt::format("{}{}--{}", order.empty() ? "" : ", ", i, j);
        text += fmt::format("{}{} ({})", text.empty() ? "" : "; ", atlas.scenes[r].name, order);
    }
    return text.empty() ? "none" : text;
}

Macros macros_of(Atlas const& atlas, Profile const profile, Verdict const verdict) {
    Macros macros("FailureAtlas");
    macros.define("Verdict", validation::name_of(verdict));
    macros.define("Profile", validation::name_of(profile));
    macros.define("Scenes", cell(atlas.rows.size()));
    macros.define("Methods", cell(atlas.contenders.size()));
    macros.define("Allowance", fmt::format("{:g}", allowance));
    macros.define("FastFailures", cell(atlas.failures(atlas.column(champion))));
    macros.define("FloatFailures", cell(atlas.failures(atlas.column("fast float"))));
    macros.define("FrameFailures", cell(atlas.failures(atlas.column("frames"))));
    macros.define("NaiveRootFailures", cell(atlas.failures(atlas.column("naive root"))));
    macros.define("NeverFailures", cell(atlas.failures(atlas.column("zero is never"))));
    macros.define("NotTheSameFailures", cell(atlas.failures(atlas.column("not the same again"))));
    macros.define("AbsoluteTimeFailures", cell(atlas.failures(atlas.column("absolute time"))));
    macros.define("FloorFailures", cell(atlas.failures(atlas.column("cell by floor(x)"))));
    macros.define("Ties", ties_of(atlas));
    Extent longest;
    for (Row const& row : atlas.rows) {
        Extent const& extent = row.cells[atlas.column(champion)].extent;
        if (extent.collisions > longest.collisions) longest = extent;
    }
    macros.define("LongestRun", significant(longest.collisions, 2));
    macros.define("LongestDrift", significant(longest.energy_drift, 1));
    macros.define("LongestOverlap", significant(longest.deepest_overlap, 1));
    return macros;
}

void show(Scene const& scene, std::vector<Contender> const& contenders, Row const& row) {
    std::cout << fmt::format("{} (k: {})\n", scene.name, scene.parameter);
    if (row.no_limit_from >= scene.levels.front())
        std::cout << fmt::format("    physics has no answer from k = {:g} on\n", row.no_limit_from);
    for (std::size_t c = 0; c < contenders.size(); ++c) {
        Cell const& found = row.cells[c];
        if (found.worst == Kind::ok || found.worst == Kind::not_run) continue;
        std::cout << fmt::format("    {:20} {}: digits from k = {:.3g} on, more from {:.3g} on, "
                                 "{:.1f} digits lost\n",
                                 contenders[c].name, name_of(found.worst), found.threshold,
                                 found.gross, found.digits);
    }
}

} // namespace

Verdict ask(Experiment& experiment) {
    Atlas atlas{scenes(experiment.profile()), contenders(), {}};
    SoftBalls soft;
    std::string const with = soft.name();
    for (Scene const& scene : atlas.scenes) {
        std::string const point =
            fmt::format("{} k={} {}", scene.name, fmt::join(scene.levels, ","), with);
        auto const found = experiment.campaign().replicates(point, 1, [&](std::uint64_t) {
            return flat(RowMeasurement(scene, atlas.contenders).measure(soft));
        });
        atlas.rows.push_back(unflat(found.front(), atlas.contenders.size()));
        show(scene, atlas.contenders, atlas.rows.back());
    }
    Verdict const verdict =
        atlas.champion_stands() && atlas.has_power() ? Verdict::agrees : Verdict::differs;
    experiment.write(csv_of(atlas));
    experiment.write_table(table_of(atlas));
    experiment.write(macros_of(atlas, experiment.profile(), verdict));
    return verdict;
}

} // namespace clack::validation
