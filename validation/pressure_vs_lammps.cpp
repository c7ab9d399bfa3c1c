// Does the pressure of soft elastic balls, as LAMMPS moves them, tend to the engine's and to
// theory's as they harden, and do they act as hard balls of the Barker-Henderson diameter?

#include "validation/pressure_vs_lammps.hpp"

#include <algorithm>
#include <cmath>

namespace clack::validation {

using namespace pressure_vs_lammps;

Question const question{
    "pressure_vs_lammps",
    "Do soft elastic balls, as LAMMPS moves them step by step, have the pressure of the engine's "
    "hard balls and of theory once they are widened to a Barker-Henderson diameter of 1?",
    "1.5 % of the collisional part Zc (full profile 0.5 %)",
    "half (a third) of what softness does to balls that are not widened, where it does least"};

namespace {

/// How far Z of the soft balls that are judged is from theory's for hard ones, at the worst.  [%]
std::string worst_percent(std::vector<StatePoint> const& points, auto const& soft) {
    double worst = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
        for (std::size_t k = points[p].first_judged; k < points[p].stiffnesses.size(); ++k)
            worst = std::max(worst, std::abs(soft(p, k).value / points[p].theory() - 1));
    return significant(100 * worst, 2);
}

} // namespace

Verdict ask(Experiment& experiment) {
    auto const points = state_points(experiment.profile());
    auto const replicates = experiment.campaign().replicates(tasks_of(points, measure));
    double const part = margin(experiment.profile());
    Ledger ledger({{"packing_fraction", "$\\eta$"}, {"stiffness", "$k$"}});
    for (std::size_t p = 0; p < points.size(); ++p) enter(ledger, points[p], replicates[p], part);
    Macros macros("PressureVsLammps");
    macros.define("SoftestJudged",
                  significant(points.front().stiffnesses[points.front().first_judged], 1));
    macros.define("LargestDeviationPercent",
                  worst_percent(points, [&](std::size_t const p, std::size_t const k) {
                      return hardened(points[p], replicates[p], k);
                  }));
    macros.define("LargestPlainPercent",
                  worst_percent(points, [&](std::size_t const p, std::size_t const k) {
                      return mean_of(replicates[p], place_of(k, Width::plain));
                  }));
    macros.define("MarginPercent", significant(100 * part, 2));
    return conclude(experiment, ledger, macros, risks);
}

} // namespace clack::validation
