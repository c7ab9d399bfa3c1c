#pragma once
// A row of the failure atlas, measured: every method from easy to hard, and where it breaks.

#include "validation/atlas_lammps.hpp"
#include "validation/atlas_methods.hpp"
#include "validation/atlas_scenes.hpp"

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace clack::validation::atlas {

/// How a method fares in a scene, over all degrees of difficulty.
struct Cell {
    static constexpr double never = std::numeric_limits<double>::quiet_NaN();

    Kind worst = Kind::not_run;
    double digits = 0;               // the most that is lost
    double threshold = never;        // k from which on it fails
    double gross = never;            // k from which on it loses more than digits
    double reached = never;          // the hardest k that was run
    Absence absence = Absence::none; // why some k were not, the easiest of them
    Extent extent{};                 // of its longest run

    bool fails() const { return worst != Kind::ok && worst != Kind::not_run; }
    void add(double k, Judged const& judged) {
        if (judged.kind == Kind::not_run) {
            if (absence == Absence::none) absence = judged.absence;
            return;
        }
        if (worst == Kind::not_run || judged.kind > worst) worst = judged.kind;
        if (!(reached >= k)) reached = k;
        if (judged.extent.collisions >= extent.collisions) extent = judged.extent;
        if (judged.kind == Kind::ok) return;
        digits = std::max(digits, judged.digits);
        if (!(threshold <= k)) threshold = k;
        if (is_gross(judged.kind) && !(gross <= k)) gross = k;
    }
};

struct Row {
    std::vector<Cell> cells;            // one a contender
    double no_limit_from = Cell::never; // k at which physics has none
    std::vector<Meeting> tie;           // what the tie rule then makes of it: the first meetings
};

class RowMeasurement {
public:
    RowMeasurement(Scene const& scene, std::vector<Contender> const& contenders)
        : scene_(scene), contenders_(contenders) {}

    Row measure(SoftBalls& soft) {
        Row row;
        for (Contender const& contender : contenders_)
            row.cells.push_back(measure(contender, soft));
        for (double const k : scene_.levels) {
            Posed const& posed = pose(k);
            if (posed.reference.has_limit || row.no_limit_from <= k) continue;
            row.no_limit_from = k;
            constexpr std::size_t shown = 6;
            row.tie = tie_breaker(posed.problem).meetings;
            row.tie.resize(std::min(row.tie.size(), shown));
        }
        return row;
    }

private:
    struct Posed {
        Problem problem;
        Reference reference;
    };
    using Levels = std::vector<double>;

    Posed const& pose(double k) {
        auto found = posed_.find(k);
        if (found == posed_.end()) {
            Problem const problem = scene_.make(k);
            found = posed_.emplace(k, Posed{problem, reference_of(problem)}).first;
        }
        return found->second;
    }

    /// From easy to hard; then three halvings of the step before it first fails, and of that before
    /// it first loses more than digits.
    Cell measure(Contender const& contender, SoftBalls& soft) {
        bool const is_soft = contender.family == Contender::Family::lammps;
        Levels const levels = is_soft ? some_levels() : scene_.levels;
        std::vector<Judged> const found = judged_at(contender, levels, soft);
        Cell cell;
        for (std::size_t n = 0; n < found.size(); ++n) cell.add(levels[n], found[n]);
        for (auto const fails : {+[](Kind kind) { return kind != Kind::ok; }, is_gross})
            narrow(cell, contender, levels, found, soft, fails);
        return cell;
    }

    void narrow(Cell& cell, Contender const& contender, Levels const& levels,
                std::vector<Judged> const& found, SoftBalls& soft, bool (*fails)(Kind)) {
        constexpr int halvings = 3;
        std::optional<double> passed, failed;
        for (std::size_t n = 0; n < found.size() && !failed; ++n)
            if (found[n].kind != Kind::not_run)
                (fails(found[n].kind) ? failed : passed) = levels[n];
        if (!passed || !failed) return;
        for (int step = 0; step < halvings; ++step) {
            double const middle = (*passed + *failed) / 2;
            Judged const judged = judged_at(contender, {middle}, soft).front();
            if (judged.kind == Kind::not_run) return;
            cell.add(middle, judged);
            (fails(judged.kind) ? failed : passed) = middle;
        }
    }

    /// As many as there are levels, but that what hangs is not tried harder.
    std::vector<Judged> judged_at(Contender const& contender, Levels const& levels,
                                  SoftBalls& soft) {
        if (contender.family == Contender::Family::lammps)
            return soft_judged_at(contender, levels, soft);
        std::vector<Judged> all;
        for (double const k : levels) {
            all.push_back(judged_at(contender, k));
            if (all.back().kind == Kind::hang) break;
        }
        return all;
    }

    Judged judged_at(Contender const& contender, double k) {
        Posed const& posed = pose(k);
        Judged const found = judged(contender, posed.problem, posed.reference);
        bool const tied = posed.reference.exists && !posed.reference.has_limit;
        if (found.kind != Kind::ok || !tied || contender.family != Contender::Family::clack_double)
            return found;
        // Physics has no answer, but the tie rule has one, whatever the method.
        Trace const ruled = tie_breaker(posed.problem), other = contender.fly(posed.problem);
        bool same = ruled.meetings == other.meetings;
        for (std::size_t frame = 0; frame < ruled.frames.size(); ++frame)
            same &= ruled.frames[frame].places == other.frames[frame].places;
        return same ? found : Judged{Kind::order, 0};
    }

    static Trace tie_breaker(Problem const& problem) {
        return clack_method(Method::table, Precision::double_).fly(problem);
    }

    /// Five degrees of difficulty at most: a run of LAMMPS takes its time.
    Levels some_levels() const {
        std::size_t const count = scene_.levels.size(), some = std::min<std::size_t>(count, 5);
        Levels levels;
        for (std::size_t n = 0; n < some; ++n)
            levels.push_back(scene_.levels[some > 1 ? n * (count - 1) / (some - 1) : 0]);
        return levels;
    }

    std::vector<Judged> soft_judged_at(Contender const& contender, Levels const& levels,
                                       SoftBalls& soft) {
        std::vector<SoftProblem> problems;
        for (double const k : levels) problems.push_back({pose(k).problem, contender.stiffness});
        auto const traces = soft.fly(problems);
        std::vector<Judged> all;
        for (std::size_t n = 0; n < levels.size(); ++n) {
            Posed const& posed = pose(levels[n]);
            all.push_back(
                traces[n] ? judge(posed.problem, posed.reference, *traces[n], contender.roundoff())
                          : Judged::absent(soft.absence(problems[n])));
        }
        return all;
    }

    Scene scene_;
    std::vector<Contender> contenders_;
    std::map<double, Posed> posed_;
};

/// A cell as campaign and data keep it.
inline constexpr std::array number_names{"outcome_code", "digits_lost",  "threshold_k",
                                         "gross_from_k", "reached_k",    "absence_code",
                                         "collisions",   "energy_drift", "deepest_overlap"};
inline Measurement numbers_of(Cell const& cell) {
    return {static_cast<double>(cell.worst),
            cell.digits,
            cell.threshold,
            cell.gross,
            cell.reached,
            static_cast<double>(cell.absence),
            cell.extent.collisions,
            cell.extent.energy_drift,
            cell.extent.deepest_overlap};
}

/// A row as the campaign keeps it.
inline Measurement flat(Row const& row) {
    Measurement numbers;
    for (Cell const& cell : row.cells) {
        Measurement const more = numbers_of(cell);
        numbers.insert(numbers.end(), more.begin(), more.end());
    }
    numbers.push_back(row.no_limit_from);
    for (auto const& [i, j] : row.tie)
        numbers.insert(numbers.end(), {static_cast<double>(i), static_cast<double>(j)});
    return numbers;
}

inline Row unflat(Measurement const& numbers, std::size_t cells) {
    Row row;
    std::size_t at = 0;
    auto const next = [&] { return numbers.at(at++); };
    for (std::size_t k = 0; k < cells; ++k) {
        Cell cell;
        cell.worst = static_cast<Kind>(static_cast<int>(next()));
        for (double* const number : {&cell.digits, &cell.threshold, &cell.gross, &cell.reached})
            *number = next();
        cell.absence = static_cast<Absence>(static_cast<int>(next()));
        cell.extent = {next(), next(), next()}; // in this order: braces see to it
        row.cells.push_back(cell);
    }
    row.no_limit_from = next();
    while (at + 1 < numbers.size()) {
        auto const i = static_cast<std::int64_t>(next());
        row.tie.emplace_back(i, static_cast<std::int64_t>(next()));
    }
    return row;
}

} // namespace clack::validation::atlas
