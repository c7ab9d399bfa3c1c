#pragma once
// A row of the failure atlas, measured: every method from easy to hard, and where it breaks.

#include "validation/atlas_lammps.hpp"
#include "validation/atlas_methods.hpp"
#include "validation/atlas_scenes.hpp"

#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace clack::validation::atlas {

/// How a method fares in a scene.
struct Cell {
    Kind worst = Kind::not_run;                                  // over all degrees of difficulty
    double digits = 0;                                           // the most that is lost
    double threshold = std::numeric_limits<double>::quiet_NaN(); // k from which on it fails

    void add(double k, Judged const& judged) {
        if (judged.kind == Kind::not_run) return;
        if (worst == Kind::not_run || judged.kind > worst) worst = judged.kind;
        digits = std::max(digits, judged.kind == Kind::ok ? 0 : judged.digits);
        if (judged.kind != Kind::ok && !(threshold <= k)) threshold = k;
    }
};

struct Row {
    std::vector<Cell> cells;                                         // one a contender
    double no_limit_from = std::numeric_limits<double>::quiet_NaN(); // k at which physics has none
    std::vector<Meeting> tie; // what the tie rule then makes of it: the first meetings
};

class RowMeasurement {
public:
    RowMeasurement(Scene const& scene, std::vector<Contender> const& contenders)
        : scene_(scene), contenders_(contenders) {}

    Row measure(SoftBalls& soft) {
        Row row;
        for (Contender const& contender : contenders_)
            row.cells.push_back(contender.family == Contender::Family::lammps
                                    ? measure_soft(contender, soft)
                                    : measure(contender));
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

    Posed const& pose(double k) {
        auto found = posed_.find(k);
        if (found == posed_.end()) {
            Problem const problem = scene_.make(k);
            found = posed_.emplace(k, Posed{problem, reference_of(problem)}).first;
        }
        return found->second;
    }

    /// From easy to hard; where it first fails, three halvings of the step before.
    Cell measure(Contender const& contender) {
        constexpr int halvings = 3;
        Cell cell;
        std::optional<double> passed;
        for (double const k : scene_.levels) {
            bool const failed_before = cell.threshold <= k;
            cell.add(k, judged_at(contender, k));
            bool const failed = cell.threshold <= k;
            if (!failed) passed = k;
            if (!failed || failed_before || !passed) continue;
            double low = *passed;
            for (int step = 0; step < halvings; ++step) {
                double const middle = (low + cell.threshold) / 2;
                Judged const found = judged_at(contender, middle);
                if (found.kind == Kind::ok) low = middle;
                cell.add(middle, found);
            }
        }
        return cell;
    }

    Judged judged_at(Contender const& contender, double k) {
        Posed const& posed = pose(k);
        Judged const found = judged(contender, posed.problem, posed.reference);
        bool const tied = posed.reference.exists && !posed.reference.has_limit;
        if (found.kind != Kind::ok || !tied || contender.family != Contender::Family::clack_double)
            return found;
        // Physics has no answer, but the tie rule has one, whatever the method.
        Trace const ruled = tie_breaker(posed.problem), other = *contender.fly(posed.problem);
        bool same = ruled.meetings == other.meetings;
        for (std::size_t frame = 0; frame < ruled.frames.size(); ++frame)
            same &= ruled.frames[frame].places == other.frames[frame].places;
        return same ? found : Judged{Kind::order, 0};
    }

    static Trace tie_breaker(Problem const& problem) {
        return *clack_method(Method::table, Precision::double_).fly(problem);
    }

    /// A few degrees of difficulty only: a run of LAMMPS takes its time.
    Cell measure_soft(Contender const& contender, SoftBalls& soft) {
        std::vector<double> const& all = scene_.levels;
        std::vector<double> const some{all.front(), all[all.size() / 2], all.back()};
        std::vector<SoftProblem> problems;
        for (double const k : some) problems.push_back({pose(k).problem, contender.stiffness});
        auto const traces = soft.fly(problems);
        Cell cell;
        for (std::size_t n = 0; n < some.size(); ++n) {
            Posed const& posed = pose(some[n]);
            if (traces[n])
                cell.add(some[n],
                         judge(posed.problem, posed.reference, *traces[n], contender.roundoff()));
        }
        return cell;
    }

    Scene scene_;
    std::vector<Contender> contenders_;
    std::map<double, Posed> posed_;
};

/// A row as the campaign keeps it.
inline Measurement flat(Row const& row) {
    Measurement numbers;
    for (Cell const& cell : row.cells)
        numbers.insert(numbers.end(),
                       {static_cast<double>(cell.worst), cell.digits, cell.threshold});
    numbers.push_back(row.no_limit_from);
    for (auto const& [i, j] : row.tie)
        numbers.insert(numbers.end(), {static_cast<double>(i), static_cast<double>(j)});
    return numbers;
}

inline Row unflat(Measurement const& numbers, std::size_t cells) {
    Row row;
    std::size_t at = 0;
    for (std::size_t cell = 0; cell < cells; ++cell, at += 3)
        row.cells.push_back({static_cast<Kind>(static_cast<int>(numbers.at(at))),
                             numbers.at(at + 1), numbers.at(at + 2)});
    row.no_limit_from = numbers.at(at++);
    for (; at + 1 < numbers.size(); at += 2)
        row.tie.emplace_back(static_cast<std::int64_t>(numbers[at]),
                             static_cast<std::int64_t>(numbers[at + 1]));
    return row;
}

} // namespace clack::validation::atlas
