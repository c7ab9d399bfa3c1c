#include "validation/harness/verdict.hpp"

#include "validation/harness/many_tests.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace clack::validation {

namespace {

std::optional<double> worst_z;
constexpr double least_p = 1e-300; // of which there is still a deviate

void note(double const z) { worst_z = std::max(z, worst_z.value_or(0)); }

/// z and the two p-values of one comparison alone.
Judgement tested(Comparison const& comparison) {
    Estimate const& measured = comparison.measured;
    double const error = std::hypot(measured.error, comparison.reference_error);
    bool const has_margin = comparison.asks != Asks::whether_at_least;
    if (!((comparison.margin > 0 || !has_margin) && error > 0)) {
        throw std::invalid_argument(fmt::format("{}: margin = {}, error = {}: must be positive",
                                                comparison.name, comparison.margin, error));
    }
    double const difference = measured.value - comparison.reference;
    double const size = std::abs(difference);
    auto const tail = [&](double const distance) {
        return upper_tail(distance / error, measured.degrees_of_freedom);
    };
    Judgement judgement;
    judgement.z = difference / error;
    if (!has_margin) {
        judgement.against = std::max(0.0, -judgement.z);
        judgement.p_differs = tail(-difference);
        judgement.p_agrees = tail(difference);
        return judgement;
    }
    // Both tails: a true difference at the margin can be exceeded on either side.
    judgement.p_differs =
        std::min(1.0, tail(size - comparison.margin) + tail(size + comparison.margin));
    judgement.p_agrees = tail(comparison.margin - size);
    if (comparison.asks == Asks::whether_apart)
        std::swap(judgement.p_differs, judgement.p_agrees);
    else
        judgement.against = std::abs(judgement.z);
    return judgement;
}

} // namespace

char const* name_of(Verdict const verdict) {
    switch (verdict) {
    case Verdict::agrees:
        return "agrees";
    case Verdict::differs:
        return "differs";
    case Verdict::undecided:
        break;
    }
    return "undecided";
}

std::vector<Judgement> judge(std::vector<Comparison> const& comparisons, Risks const& risks) {
    std::vector<Judgement> judgements;
    std::vector<double> p_values;
    for (Comparison const& comparison : comparisons) {
        judgements.push_back(tested(comparison));
        p_values.push_back(judgements.back().p_differs);
    }
    std::vector<double> const adjusted = holm(p_values);
    for (std::size_t k = 0; k < judgements.size(); ++k) {
        Judgement& judgement = judgements[k];
        if (judgement.against > 0) note(judgement.against);
        judgement.p_differs = adjusted[k];
        if (judgement.p_differs < risks.false_alarm) {
            judgement.verdict = Verdict::differs;
        } else if (judgement.p_agrees < risks.false_agreement) {
            judgement.verdict = Verdict::agrees;
        }
    }
    return judgements;
}

std::vector<Verdict> judge(std::vector<GoodnessOfFit> const& tests, double const false_alarm) {
    std::vector<double> p_values;
    p_values.reserve(tests.size());
    for (GoodnessOfFit const& test : tests) {
        p_values.push_back(test.p_value);
        note(gsl_cdf_ugaussian_Qinv(std::max(test.p_value, least_p) / 2));
    }
    std::vector<Verdict> verdicts;
    for (double const p : holm(p_values))
        verdicts.push_back(p < false_alarm ? Verdict::differs : Verdict::agrees);
    return verdicts;
}

std::optional<double> worst_z_judged() { return worst_z; }

void forget_judged() { worst_z.reset(); }

Verdict together(std::vector<Verdict> const& verdicts) {
    auto const any = [&](Verdict const verdict) {
        return std::find(verdicts.begin(), verdicts.end(), verdict) != verdicts.end();
    };
    if (any(Verdict::differs)) return Verdict::differs;
    return verdicts.empty() || any(Verdict::undecided) ? Verdict::undecided : Verdict::agrees;
}

Verdict together(std::vector<Judgement> const& judgements) {
    std::vector<Verdict> verdicts;
    verdicts.reserve(judgements.size());
    for (Judgement const& judgement : judgements) verdicts.push_back(judgement.verdict);
    return together(verdicts);
}

int exit_code(Verdict const verdict) { return verdict == Verdict::agrees ? 0 : 1; }

} // namespace clack::validation
