#include "validation/harness/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <utility>

namespace clack::validation {

void Ledger::compare(std::vector<std::string> state, Quantity quantity, Comparison comparison) {
    comparison.name = quantity.name;
    entries_.push_back(
        {Kind::compared, std::move(state), std::move(quantity), std::move(comparison)});
}

void Ledger::guide(std::vector<std::string> state, Quantity quantity, Comparison comparison) {
    comparison.name = quantity.name;
    double const error = std::hypot(comparison.measured.error, comparison.reference_error);
    double const z = (comparison.measured.value - comparison.reference) / error;
    entries_.push_back(
        {Kind::guide, std::move(state), std::move(quantity), std::move(comparison), 1, z});
}

void Ledger::fit(std::vector<std::string> state, Quantity quantity, double const p_value) {
    entries_.push_back({Kind::fit, std::move(state), std::move(quantity), {}, p_value});
}

void Ledger::bound(std::vector<std::string> state, Quantity quantity, double const value,
                   double const reference, double const bound) {
    Entry entry{Kind::bound, std::move(state), std::move(quantity), {}};
    entry.comparison.measured.value = value;
    entry.comparison.reference = reference;
    entry.comparison.margin = bound;
    // A value that is not a number is no agreement.
    entry.verdict = std::abs(value - reference) <= bound ? Verdict::agrees : Verdict::differs;
    entries_.push_back(std::move(entry));
}

void Ledger::judge(Risks const& risks) {
    std::vector<Comparison> comparisons;
    std::vector<GoodnessOfFit> fits;
    for (Entry const& entry : entries_) {
        if (entry.kind == Kind::compared) comparisons.push_back(entry.comparison);
        if (entry.kind == Kind::fit) fits.push_back({entry.quantity.name, entry.p_value});
    }
    auto const judgements = validation::judge(comparisons, risks);
    auto const fitted = validation::judge(fits, risks.false_alarm);
    std::size_t compared = 0, tested = 0;
    for (Entry& entry : entries_) {
        if (entry.kind == Kind::compared) {
            entry.z = judgements[compared].z;
            entry.verdict = judgements[compared++].verdict;
        }
        if (entry.kind == Kind::fit) entry.verdict = fitted[tested++];
    }
}

Verdict Ledger::verdict(std::string const& quantity) const {
    std::vector<Verdict> verdicts;
    for (Entry const& entry : entries_)
        if (entry.kind != Kind::guide && (quantity.empty() || entry.quantity.name == quantity))
            verdicts.push_back(entry.verdict);
    return together(verdicts);
}

Csv Ledger::csv() const {
    std::vector<std::string> columns;
    for (Key const& key : keys_) columns.push_back(key.column);
    for (char const* const name : {"quantity", "measured", "measured_error", "reference",
                                   "reference_error", "margin", "z", "p_value", "verdict"})
        columns.emplace_back(name);
    Csv csv(columns);
    for (Entry const& entry : entries_) {
        Comparison const& c = entry.comparison;
        std::vector<std::string> cells = entry.state;
        cells.push_back(entry.quantity.name);
        bool const is_fit = entry.kind == Kind::fit;
        for (double const number : {c.measured.value, c.measured.error, c.reference,
                                    c.reference_error, c.margin, entry.z})
            cells.push_back(cell(is_fit ? std::numeric_limits<double>::quiet_NaN() : number));
        cells.push_back(cell(is_fit ? entry.p_value : std::numeric_limits<double>::quiet_NaN()));
        cells.push_back(entry.word());
        csv.row(cells);
    }
    return csv;
}

std::string Ledger::table() const {
    std::string alignment;
    std::vector<std::string> head;
    for (Key const& key : keys_) {
        alignment += 'r';
        head.push_back(key.head);
    }
    for (char const* const title : {"quantity", "measured", "expected", "$z$", "verdict"})
        head.emplace_back(title);
    std::vector<std::vector<std::string>> rows;
    for (Entry const& entry : entries_) {
        Comparison const& c = entry.comparison;
        std::vector<std::string> row = entry.state;
        row.push_back(entry.quantity.symbol);
        switch (entry.kind) {
        case Kind::fit:
            row.insert(row.end(), {fmt::format("$p = {:.2f}$", entry.p_value), "", ""});
            break;
        case Kind::bound:
            row.insert(row.end(),
                       {significant(c.measured.value, 6), significant(c.reference, 6), ""});
            break;
        default:
            row.insert(row.end(),
                       {with_error(c.measured), with_error({c.reference, c.reference_error}),
                        fmt::format("${:+.1f}$", entry.z)});
        }
        row.push_back(entry.word());
        rows.push_back(row);
    }
    return tabular(alignment + "lllrl", head, rows);
}

void Ledger::define(Macros& macros, Profile const profile) const {
    double largest_z = 0;
    std::size_t compared = 0;
    for (Entry const& entry : entries_) {
        if (entry.kind != Kind::compared) continue;
        ++compared;
        largest_z = std::max(largest_z, std::abs(entry.z));
    }
    macros.define("Profile", validation::name_of(profile));
    macros.define("Comparisons", cell(compared));
    macros.define("LargestZ", significant(largest_z, 2));
    macros.define("FalseAlarmPercent", significant(100 * Risks{}.false_alarm, 1));
    macros.define("Verdict", name_of(verdict()));
}

std::string Ledger::text() const {
    std::string text;
    for (Entry const& entry : entries_) {
        for (std::size_t k = 0; k < keys_.size(); ++k)
            text += fmt::format("{} {}, ", keys_[k].column, entry.state.at(k));
        Comparison const& c = entry.comparison;
        text += entry.quantity.name;
        if (entry.kind == Kind::fit) {
            text += fmt::format(": p = {:.3f}", entry.p_value);
        } else {
            text += fmt::format(": {} reference {}", with_error(c.measured),
                                with_error({c.reference, c.reference_error}));
            text += entry.kind == Kind::bound ? fmt::format(" within {:.3g}", c.margin)
                                              : fmt::format(" z = {:+.1f}", entry.z);
        }
        text += fmt::format("  {}\n", entry.word());
    }
    return text;
}

Verdict conclude(Experiment& experiment, Ledger& ledger, Macros macros) {
    ledger.judge();
    ledger.define(macros, experiment.profile());
    std::cout << ledger.text();
    experiment.write(macros);
    experiment.write_table(ledger.table());
    experiment.write(ledger.csv());
    return ledger.verdict();
}

} // namespace clack::validation
