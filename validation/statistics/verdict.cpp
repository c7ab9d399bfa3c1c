#include "validation/statistics/verdict.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace clack::validation {

namespace {

/// z and the two p-values of one comparison alone.
Judgement tested(Comparison const& comparison) {
    Estimate const& measured = comparison.measured;
    double const error = std::hypot(measured.error, comparison.reference_error);
    bool const has_margin = comparison.asks != Asks::whether_at_least;
    if (!((comparison.margin > 0 || !has_margin) && error > 0)) {
        throw std::invalid_argument(fmt::format(
            "{}: margin = {}, error = {}: must be positive; where nothing scatters, say the "
            "reference's own error, or enter a bound",
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
    constexpr std::array names{"agrees", "differs", "undecided"};
    return names.at(static_cast<std::size_t>(verdict));
}

std::vector<double> holm(std::vector<double> const& p_values) {
    std::vector<std::size_t> by_size(p_values.size());
    std::iota(by_size.begin(), by_size.end(), 0);
    std::sort(by_size.begin(), by_size.end(),
              [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
    std::vector<double> adjusted(p_values.size());
    double largest = 0;
    auto open = static_cast<double>(p_values.size()); // not yet refused
    for (std::size_t const k : by_size) {
        largest = std::max(largest, std::min(1.0, open-- * p_values[k]));
        adjusted[k] = largest;
    }
    return adjusted;
}

double fisher(std::vector<double> const& p_values) {
    double sum = 0;
    for (double const p : p_values)
        sum -= 2 * std::log(std::max(p, std::numeric_limits<double>::min()));
    return gsl_cdf_chisq_Q(sum, 2 * static_cast<double>(p_values.size()));
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
        judgement.p_differs = adjusted[k];
        if (judgement.p_differs < risks.false_alarm) {
            judgement.verdict = Verdict::differs;
        } else if (judgement.p_agrees < risks.false_agreement) {
            judgement.verdict = Verdict::agrees;
        }
    }
    return judgements;
}

std::vector<Verdict> judge(std::vector<double> const& p_values, double const false_alarm) {
    std::vector<Verdict> verdicts;
    for (double const p : holm(p_values))
        verdicts.push_back(p < false_alarm ? Verdict::differs : Verdict::agrees);
    return verdicts;
}

double deviate(double const p_value) {
    constexpr double least = 1e-300; // of which there is still one
    return gsl_cdf_ugaussian_Qinv(std::max(p_value, least) / 2);
}

Verdict together(std::vector<Verdict> const& verdicts) {
    auto const any = [&](Verdict const verdict) {
        return std::find(verdicts.begin(), verdicts.end(), verdict) != verdicts.end();
    };
    if (any(Verdict::differs)) return Verdict::differs;
    return verdicts.empty() || any(Verdict::undecided) ? Verdict::undecided : Verdict::agrees;
}

} // namespace clack::validation
