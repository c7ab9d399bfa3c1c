#pragma once
// Does a measurement agree with theory? Three answers, and the z-score always; and what p-values
// are worth where many are asked for.

#include "validation/statistics/estimate.hpp"

#include <limits>
#include <string>
#include <vector>

namespace clack::validation {

enum class Verdict {
    agrees,   // the difference is shown to be smaller than the margin
    differs,  // the difference is shown to be larger than the margin
    undecided // neither: run longer
};

char const* name_of(Verdict verdict);

/// What is asked of a measured number and the one beside it.
enum class Asks {
    whether_near,     // is the difference smaller than the margin?
    whether_at_least, // is the measured number no smaller? Without a margin.
    whether_apart     // is the difference larger than the margin: what is wrong must not pass?
};

/// One measured number beside the theory's. The margin, a difference that would not matter, and
/// its reason are fixed before the data exist.
struct Comparison {
    std::string name = {};
    Estimate measured = {};
    double reference = 0;
    double reference_error = 0;
    double margin = 0;
    Asks asks = Asks::whether_near;
};

/// The probabilities of a wrong verdict at one look. Twenty-five families of comparisons, more than
/// the quick profile judges, raise a false alarm with a probability of 1e-4 at most, with all that
/// is looked at again (Experiment::look).
struct Risks {
    double false_alarm = 1e-4 / 30; // any of the comparisons `differs` though none does
    double false_agreement = 0.05;  // one comparison `agrees` though it differs by the margin
};

struct Judgement {
    Verdict verdict = Verdict::undecided;
    double z = 0;         // (measured - reference) in standard errors of the difference
    double against = 0;   // as much of |z| as speaks against agreement
    double p_differs = 1; // Holm-adjusted p-value of "it is as asked"
    double p_agrees = 1;  // p-value of "it is not"
};

/// Judges comparisons together: `differs` where "it is as asked" is refused at `false_alarm` with
/// Holm's correction over all; `agrees` where "it is not" is refused at `false_agreement`, each by
/// Student's t. Where nearness is asked for these are two one-sided tests (D. J. Schuirmann,
/// J. Pharmacokin. Biopharm. 15, 657 (1987)).
/// Throws std::invalid_argument unless every margin that is asked about and every error is
/// positive.
std::vector<Judgement> judge(std::vector<Comparison> const& comparisons, Risks const& risks = {});

/// Holm's adjusted p-values, in the order of the given ones: refusing every hypothesis whose
/// adjusted p-value is below alpha refuses a true one with probability at most alpha, whatever the
/// dependence between the tests.
/// Source: S. Holm, Scand. J. Statist. 6, 65 (1979).
std::vector<double> holm(std::vector<double> const& p_values);

/// Fisher's p-value of independent tests of one hypothesis taken together.
/// Source: R. A. Fisher, Statistical Methods for Research Workers (4th ed., 1932), section 21.1.
double fisher(std::vector<double> const& p_values);

/// Tests of fit, each of which can refuse a law but not confirm it: `differs` where the law is
/// refused at `false_alarm` with Holm's correction over all, otherwise `agrees`; what that is worth
/// depends on a companion Comparison, whose margin says how far off a law would be seen.
std::vector<Verdict> judge(std::vector<double> const& p_values, double false_alarm);

/// The normal deviate whose |z| is as rare as the p-value.
double deviate(double p_value);

/// The verdict on several together: `differs` if one does, else `undecided` if one is, else
/// `agrees`.
Verdict together(std::vector<Verdict> const& verdicts);

} // namespace clack::validation
