#include "validation/harness/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

namespace clack::validation {

namespace {

using Kind = Entry::Kind;

Verdict verdict_of(std::vector<Entry> const& entries,
                   std::function<bool(Entry const&)> const& concerned) {
    std::vector<Verdict> verdicts;
    for (Entry const& entry : entries)
        if (entry.kind != Kind::guide && concerned(entry)) verdicts.push_back(entry.verdict);
    return together(verdicts);
}

/// What was expected, for people.
std::string expected(Comparison const& c) {
    return (c.asks == Asks::whether_apart ? "not " : "") +
           with_error({c.reference, c.reference_error});
}

} // namespace

void Ledger::compare(std::vector<std::string> state, Quantity quantity, Comparison comparison) {
    comparison.name = quantity.name;
    entries_.push_back(
        {Kind::compared, std::move(state), std::move(quantity), std::move(comparison)});
}

void Ledger::guide(std::vector<std::string> state, Quantity quantity, Comparison comparison) {
    compare(std::move(state), std::move(quantity), std::move(comparison));
    Entry& entry = entries_.back();
    entry.kind = Kind::guide;
    entry.z = (entry.comparison.measured.value - entry.comparison.reference) /
              std::hypot(entry.comparison.measured.error, entry.comparison.reference_error);
}

void Ledger::fit(std::vector<std::string> state, Quantity quantity, double const p_value) {
    entries_.push_back({Kind::fit, std::move(state), std::move(quantity), {}, p_value});
}

void Ledger::bound(std::vector<std::string> state, Quantity quantity, double const value,
                   double const reference, double const bound) {
    compare(std::move(state), std::move(quantity),
            {.measured = {value, 0}, .reference = reference, .margin = bound});
    entries_.back().kind = Kind::bound;
    // A value that is not a number is no agreement.
    entries_.back().verdict =
        std::abs(value - reference) <= bound ? Verdict::agrees : Verdict::differs;
}

void Ledger::judge(Risks const& risks) {
    std::vector<Comparison> comparisons;
    std::vector<double> p_values;
    for (Entry const& entry : entries_) {
        if (entry.kind == Kind::compared) comparisons.push_back(entry.comparison);
        if (entry.kind == Kind::fit) p_values.push_back(entry.p_value);
    }
    auto const judgements = validation::judge(comparisons, risks);
    auto const fitted = validation::judge(p_values, risks.false_alarm);
    auto compared = judgements.begin();
    auto tested = fitted.begin();
    for (Entry& entry : entries_) {
        if (entry.kind == Kind::fit) entry.verdict = *tested++;
        if (entry.kind != Kind::compared) continue;
        entry.z = compared->z;
        entry.against = compared->against;
        entry.verdict = (compared++)->verdict;
    }
}

Verdict Ledger::verdict(std::string const& quantity) const {
    return verdict_of(entries_, [&](Entry const& entry) {
        return quantity.empty() || entry.quantity.name == quantity;
    });
}

Verdict Ledger::verdict_at(std::vector<std::string> const& state) const {
    return verdict_of(entries_, [&](Entry const& entry) { return entry.state == state; });
}

Csv Ledger::csv() const {
    std::vector<std::string> columns;
    for (Key const& key : keys_) columns.push_back(key.column);
    columns.insert(columns.end(), {"quantity", "measured", "measured_error", "reference",
                                   "reference_error", "margin", "z", "p_value", "verdict"});
    Csv csv(columns);
    for (Entry const& entry : entries_) {
        Comparison const& c = entry.comparison;
        bool const is_fit = entry.kind == Kind::fit;
        std::vector<std::string> cells = entry.state;
        cells.push_back(entry.quantity.name);
        for (double const number : {c.measured.value, c.measured.error, c.reference,
                                    c.reference_error, c.margin, entry.z})
            cells.push_back(is_fit ? "nan" : cell(number));
        cells.push_back(is_fit ? cell(entry.p_value) : "nan");
        cells.push_back(entry.word());
        csv.row(cells);
    }
    return csv;
}

std::string Ledger::table() const {
    std::vector<std::string> head;
    for (Key const& key : keys_) head.push_back(key.head);
    head.insert(head.end(), {"quantity", "measured", "expected", "margin", "$z$", "verdict"});
    std::vector<std::vector<std::string>> rows;
    for (Entry const& entry : entries_) {
        Comparison const& c = entry.comparison;
        bool const has_chance = entry.kind != Kind::bound;
        std::vector<std::string> row = entry.state;
        row.push_back(entry.quantity.symbol);
        if (entry.kind == Kind::fit)
            row.insert(row.end(), {fmt::format("$p = {:.2f}$", entry.p_value), "", "", ""});
        else
            row.insert(row.end(),
                       {has_chance ? with_error(c.measured) : significant(c.measured.value, 6),
                        expected(c), entry.kind == Kind::guide ? "" : significant(c.margin, 2),
                        has_chance ? fmt::format("${:+.1f}$", entry.z) : ""});
        row.push_back(entry.word());
        rows.push_back(row);
    }
    return tabular(std::string(keys_.size(), 'r') + "lllrrl", head, rows);
}

std::string Ledger::text() const {
    std::string text;
    for (Entry const& entry : entries_) {
        Comparison const& c = entry.comparison;
        for (std::size_t k = 0; k < keys_.size(); ++k)
            text += fmt::format("{} {}, ", keys_[k].column, entry.state.at(k));
        text += entry.quantity.name;
        text += entry.kind == Kind::fit
                    ? fmt::format(": p = {:.3f}", entry.p_value)
                    : fmt::format(": {} reference {} margin {:.2g} z = {:+.1f}",
                                  with_error(c.measured), expected(c), c.margin, entry.z);
        text += fmt::format("  {}\n", entry.word());
    }
    return text;
}

Verdict conclude(Experiment& experiment, Ledger& ledger, Macros macros, Risks risks) {
    if (experiment.look() > 1) risks.false_alarm /= 10;
    ledger.judge(risks);
    std::cout << ledger.text();
    int comparisons = 0;
    double largest_z = 0;
    for (Entry const& entry : ledger.entries()) {
        comparisons += entry.kind == Kind::compared;
        largest_z = std::max(largest_z, entry.against);
    }
    macros.define("Profile", name_of(experiment.profile()));
    macros.define("Comparisons", cell(comparisons));
    macros.define("LargestZ", significant(largest_z, 2));
    macros.define("FalseAlarmPercent", significant(100 * risks.false_alarm, 1));
    macros.define("Verdict", name_of(ledger.verdict()));
    experiment.write(macros);
    experiment.write_table(ledger.table());
    experiment.write(ledger.csv());
    return ledger.verdict();
}

} // namespace clack::validation
