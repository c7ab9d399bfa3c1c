#pragma once
// Does a measurement agree with theory? Three answers, and the z-score always.

#include "validation/harness/interval.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace clack::validation {

enum class Verdict {
    agrees,   // the difference is shown to be smaller than the margin
    differs,  // the difference is shown to be larger than the margin
    undecided // neither: run longer
};

char const* name_of(Verdict verdict);

/// One measured number beside the theory's. The margin, a difference that would not matter, and
/// its reason are fixed before the data exist.
struct Comparison {
    std::string name = {};
    Estimate measured = {};
    double reference = 0;
    double reference_error = 0;
    double margin = 0;
};

/// The probabilities of a wrong verdict. Thirty families of comparisons, more than the quick
/// profile judges, raise a false alarm with a probability of 1e-4 at most.
struct Risks {
    double false_alarm = 1e-4 / 30; // any of the comparisons `differs` though none does
    double false_agreement = 0.05;  // one comparison `agrees` though it differs by the margin
};

struct Judgement {
    Verdict verdict = Verdict::undecided;
    double z = 0;         // (measured - reference) in standard errors of the difference
    double p_differs = 1; // Holm-adjusted p-value of "the difference is within the margin"
    double p_agrees = 1;  // p-value of "the difference is the margin or more"
};

/// Judges comparisons together: `differs` where "the difference is within the margin" is refused
/// at `false_alarm` with Holm's correction over all; `agrees` where "it is the margin or more" is
/// refused at `false_agreement` (two one-sided tests; D. J. Schuirmann, J. Pharmacokin. Biopharm.
/// 15, 657 (1987)), each by Student's t.
/// Throws std::invalid_argument unless every margin and every error is positive.
std::vector<Judgement> judge(std::vector<Comparison> const& comparisons, Risks const& risks = {});

/// One test that can refuse a law but not confirm it.
struct GoodnessOfFit {
    std::string name = {};
    double p_value = 1;
};

/// `differs` where the law is refused at `false_alarm` with Holm's correction over all, otherwise
/// `agrees`: what that is worth depends on a companion Comparison, whose margin says how far off a
/// law would be seen.
std::vector<Verdict> judge(std::vector<GoodnessOfFit> const& tests, double false_alarm);

/// The largest |z| that this program has judged so far, a p-value being worth the normal deviate
/// that is as rare: for the summary that each experiment leaves. Nothing before the first.
std::optional<double> worst_z_judged();
/// Begins again, for a program that judges what it knows to be wrong.
void forget_judged();

/// The verdict on several together: `differs` if one does, else `undecided` if one is, else
/// `agrees`.
Verdict together(std::vector<Verdict> const& verdicts);
Verdict together(std::vector<Judgement> const& judgements);

/// 0 where it agrees, 1 otherwise.
int exit_code(Verdict verdict);

} // namespace clack::validation
