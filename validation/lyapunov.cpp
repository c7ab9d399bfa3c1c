// How fast do two runs that begin nearly alike part, and does tangent space say the same as twins?

#include "validation/lyapunov.hpp"

#include <algorithm>
#include <cmath>

namespace clack::validation {

using namespace lyapunov;

Question const question{
    "lyapunov",
    "How fast does a small error grow, by the collisions of a ball, over packing fraction and "
    "number; do tangent space and twin runs agree on it; and does the program's formula hold where "
    "it was not fitted?",
    "twins against the tangent vector along the same run: " + percent(twin_margin) +
        "; the formula against tangent space: " + percent(formula_margin),
    "beyond what quad rounds and what curves at the last distance, and far less than a wrong term "
    "would change; at numbers and packing fractions that it was not fitted to, two collisions per "
    "ball of a horizon of thirty",
    Processes::one_a_state_point};

namespace {

/// How far a quantity is from its reference, at the worst of the points where it is judged or of
/// those where it is not.
double worst(Ledger const& ledger, std::string const& quantity, Entry::Kind const kind) {
    double off = 0;
    for (Entry const& entry : ledger.entries())
        if (entry.quantity.name == quantity && entry.kind == kind)
            off = std::max(
                off, std::abs(entry.comparison.measured.value / entry.comparison.reference - 1));
    return off;
}

} // namespace

Verdict ask(Experiment& experiment) {
    auto const points = state_points(experiment.profile());
    auto const replicates = experiment.campaign().replicates(tasks_of(points, measure));
    Ledger ledger({{"boundary", ""}, {"packing_fraction", "$\\eta$"}, {"count", "$n$"}});
    int held_out = 0, pairs = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        enter(ledger, points[k], replicates[k]);
        held_out += points[k].part == Part::held_out;
        pairs += points[k].part == Part::twins ? points[k].replicates : 0;
    }
    auto const of_formula = [&](Entry::Kind const kind) {
        return significant(100 * worst(ledger, "exponent", kind), 2);
    };
    Macros macros("Lyapunov");
    macros.define("FormulaWorstPercent", of_formula(Entry::Kind::compared));
    macros.define("FormulaFittedPercent", of_formula(Entry::Kind::guide));
    macros.define("FormulaMarginPercent", significant(100 * formula_margin, 2));
    macros.define("HeldOutPoints", cell(held_out));
    macros.define("TwinPairs", cell(pairs));
    macros.define("TwinsWorst",
                  significant(worst(ledger, "twins_over_tangent", Entry::Kind::compared), 1));
    macros.define("TwinsMarginPercent", significant(100 * twin_margin, 2));
    macros.define("Nudge", significant(Twins::nudge, 1));
    macros.define("Last", significant(Twins::last, 1));
    return conclude(experiment, ledger, macros);
}

} // namespace clack::validation
