#include "validation/harness/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace clack::validation {

void Findings::add(Finding finding) {
    finding.comparison.name =
        fmt::format("{} at {} = {:g}", finding.quantity, abscissa_, finding.at);
    findings_.push_back(std::move(finding));
}

void Findings::judge(Risks const& risks) {
    std::vector<Comparison> comparisons;
    for (Finding const& finding : findings_) comparisons.push_back(finding.comparison);
    auto const judgements = validation::judge(comparisons, risks);
    for (std::size_t k = 0; k < findings_.size(); ++k) findings_[k].judgement = judgements[k];
}

Verdict Findings::verdict() const {
    std::vector<Verdict> verdicts = required_;
    for (Finding const& finding : findings_) verdicts.push_back(finding.judgement.verdict);
    return together(verdicts);
}

Csv Findings::csv() const {
    Csv csv({"quantity", abscissa_, "value", "error", "reference", "reference_error", "margin", "z",
             "verdict"});
    for (auto const& [quantity, symbol, at, comparison, judgement] : findings_)
        csv.row({quantity, cell(at), cell(comparison.measured.value),
                 cell(comparison.measured.error), cell(comparison.reference),
                 cell(comparison.reference_error), cell(comparison.margin), cell(judgement.z),
                 cell(name_of(judgement.verdict))});
    return csv;
}

std::string Findings::table() const {
    std::vector<std::vector<std::string>> cells;
    for (auto const& [quantity, symbol, at, comparison, judgement] : findings_)
        cells.push_back({symbol, fmt::format("{:.4g}", at),
                         fmt::format("${}$", with_error(comparison.measured)),
                         fmt::format("{:.5g}", comparison.reference),
                         significant(comparison.margin, 1), fmt::format("${:+.1f}$", judgement.z),
                         name_of(judgement.verdict)});
    return tabular("lrlrrrl", {"", symbol_, "measured", "expected", "margin", "$z$", "verdict"},
                   cells);
}

Macros Findings::macros(std::string const& prefix, Profile const profile) const {
    double largest_z = 0;
    for (Finding const& finding : findings_)
        largest_z = std::max(largest_z, std::abs(finding.judgement.z));
    Macros macros(prefix);
    macros.define("Profile", name_of(profile));
    macros.define("Points", cell(findings_.size()));
    macros.define("LargestZ", significant(largest_z, 2));
    macros.define("FalseAlarmPercent", significant(100 * Risks{}.false_alarm, 1));
    macros.define("Verdict", name_of(verdict()));
    return macros;
}

void Findings::print() const {
    for (auto const& [quantity, symbol, at, comparison, judgement] : findings_)
        std::cout << fmt::format(
            "{:42} {:<14} expected {:<10.6g} margin {:<8.2g} z = {:+.1f}  {}\n", comparison.name,
            with_error(comparison.measured), comparison.reference, comparison.margin, judgement.z,
            name_of(judgement.verdict));
}

Verdict Findings::conclude(Experiment& experiment, std::string const& prefix,
                           std::function<void(Macros&)> const& more) {
    judge();
    print();
    Macros all = macros(prefix, experiment.profile());
    if (more) more(all);
    experiment.write(csv());
    experiment.write(all);
    experiment.write_table(table());
    return verdict();
}

} // namespace clack::validation
