// In which scenes do methods fail, which of them, and from where on?

#include "validation/atlas_table.hpp"
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

Csv csv_of(Atlas const& atlas) {
    std::vector<std::string> columns{"row",    "scene",  "parameter",      "column",
                                     "method", "last_k", "no_limit_from_k"};
    columns.insert(columns.end(), number_names.begin(), number_names.end());
    Csv csv(columns);
    for (std::size_t r = 0; r < atlas.rows.size(); ++r) {
        Scene const& scene = atlas.scenes[r];
        for (std::size_t c = 0; c < atlas.contenders.size(); ++c) {
            std::vector<std::string> cells{cell(r),
                                           scene.name,
                                           scene.parameter,
                                           cell(c),
                                           atlas.contenders[c].name,
                                           cell(scene.levels.back()),
                                           cell(atlas.rows[r].no_limit_from)};
            for (double const number : numbers_of(atlas.rows[r].cells[c]))
                cells.push_back(cell(number));
            csv.row(cells);
        }
    }
    return csv;
}

Macros macros_of(Atlas const& atlas, Profile const profile) {
    Macros macros("FailureAtlas");
    macros.define("Profile", name_of(profile));
    macros.define("Scenes", cell(atlas.rows.size()));
    macros.define("Methods", cell(atlas.contenders.size()));
    macros.define("Allowance", fmt::format("{:g}", allowance));
    for (auto const& [macro, name] : {std::pair{"Fast", champion},
                                      {"Float", "fast float"},
                                      {"Frame", "frames"},
                                      {"NaiveRoot", "naive root"},
                                      {"Never", "zero is never"},
                                      {"NotTheSame", "not the same again"},
                                      {"AbsoluteTime", "absolute time"},
                                      {"Floor", "cell by floor(x)"}})
        macros.define(std::string(macro) + "Failures", cell(atlas.failures(name)));
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

} // namespace

Verdict ask(Experiment& experiment) {
    auto const draw = static_cast<Draw>(experiment.seed_set());
    Atlas atlas{scenes(experiment.profile(), draw), contenders(), {}};
    SoftBalls soft;
    for (Scene const& scene : atlas.scenes) {
        std::string const point =
            fmt::format("{} k={} {}", scene.name, fmt::join(scene.levels, ","), soft.name());
        auto const found = experiment.campaign().replicates(point, 1, [&](std::uint64_t) {
            return flat(RowMeasurement(scene, atlas.contenders).measure(soft));
        });
        atlas.rows.push_back(unflat(found.front(), atlas.contenders.size()));
    }
    bool as_asked = true;
    for (Contender const& contender : atlas.contenders) {
        auto const failures = atlas.failures(contender.name);
        std::cout << fmt::format("{} fails in {} scenes\n", contender.name, failures);
        if (contender.name == champion) as_asked &= failures == 0;
        if (contender.family == Contender::Family::textbook) as_asked &= failures > 0;
    }
    experiment.write(csv_of(atlas));
    experiment.write_table(table_of(atlas));
    experiment.write(macros_of(atlas, experiment.profile()));
    return as_asked ? Verdict::agrees : Verdict::differs;
}

} // namespace clack::validation
